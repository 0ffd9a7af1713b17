// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "absl/status/statusor.h"

namespace flair::orchestrator {

// A process's claim to be alive: a file that it keeps locked. The kernel lets go of the lock however the process ends,
// so no clock and no process number decides whether the owner of a job is dead. Works between containers that share the
// folder on one machine.
class OwnerLock {
 public:
  // Makes FOLDER/ID.lock under a new id and locks it.
  static absl::StatusOr<OwnerLock> Acquire(const std::string& folder);
  OwnerLock(OwnerLock&& other) noexcept;
  OwnerLock& operator=(OwnerLock&&) = delete;
  // Lets go and removes the file.
  ~OwnerLock();

  const std::string& id() const { return id_; }

  // True when no process holds the lock of that id; then its file is removed.
  static bool IsDead(const std::string& folder, const std::string& id);

 private:
  OwnerLock(std::string id, std::string path, int file) : id_(std::move(id)), path_(std::move(path)), file_(file) {}

  std::string id_;
  std::string path_;
  int file_;
};

}  // namespace flair::orchestrator
