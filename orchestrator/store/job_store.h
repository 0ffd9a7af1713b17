// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "absl/status/statusor.h"
#include "orchestrator/store/batch_table.h"
#include "orchestrator/store/database.h"
#include "orchestrator/store/job_table.h"

namespace flair::orchestrator {

// A process's claim to be alive: a file that it keeps locked. The kernel releases the lock however the process ends, so
// no clock and no process number decides whether the owner of a job is dead. Works between containers that share the
// folder on one machine.
class OwnerLock {
 public:
  // Makes FOLDER/ID.lock under a new id and locks it.
  static absl::StatusOr<OwnerLock> Acquire(const std::string& folder);
  OwnerLock(OwnerLock&& other) noexcept;
  OwnerLock& operator=(OwnerLock&&) = delete;
  // Unlocks and removes the file.
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

// The tables of a store's folder, jobs.db, and this process's claim to be alive, owners/. Several processes may have it
// open. Thread-safe.
class JobStore {
 public:
  // Opens the folder, makes it when missing, and gives back the jobs of processes that died. INVALID_ARGUMENT for an
  // empty path, UNAVAILABLE when the folder cannot be made or written.
  static absl::StatusOr<std::unique_ptr<JobStore>> Open(const std::string& path);

  const std::string& path() const { return path_; }
  // This process, as owner of jobs.
  const std::string& owner() const { return owner_.id(); }
  Database& database() { return *database_; }
  JobTable& jobs() { return jobs_; }
  BatchTable& batches() { return batches_; }
  DeletionTable& deletions() { return deletions_; }

  // Makes RUNNING jobs whose process has died QUEUED again.
  absl::Status ReleaseDeadOwners();

  std::string owners_path() const { return path_ + "/owners"; }

 private:
  JobStore(std::string path, std::unique_ptr<Database> database, OwnerLock owner)
      : path_(std::move(path)), owner_(std::move(owner)), database_(std::move(database)) {}

  const std::string path_;
  OwnerLock owner_;
  std::unique_ptr<Database> database_;
  JobTable jobs_{*database_};
  BatchTable batches_{*database_};
  DeletionTable deletions_{*database_};
};

// Notices what other processes do to a store: that they wrote to it, and that one of them ended. Woken by the kernel
// (inotify on the write-ahead log and on the owner locks); where that does not work, such as on network file systems,
// it looks once a second. The store outlives it.
class StoreMonitor {
 public:
  struct Callbacks {
    // Another process changed the store.
    std::function<void()> changed;
    // An owner may have died, or the store was not looked at for a second.
    std::function<void()> owner_gone;
  };

  // Calls back from a thread of its own, one call at a time.
  StoreMonitor(JobStore& store, Callbacks callbacks);
  ~StoreMonitor();

 private:
  void Watch();
  bool ChangedElsewhere();

  JobStore& store_;
  const Callbacks callbacks_;
  int notify_file_ = -1;
  int owners_watch_ = -1;
  int stop_file_ = -1;
  int64_t version_ = -1;
  std::thread thread_;
};

}  // namespace flair::orchestrator
