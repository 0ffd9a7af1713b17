// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "orchestrator/store/artifact_id.h"
#include "orchestrator/store/database.h"

namespace flair::orchestrator {

// The bytes of artifacts as rows of one SQLite file: many small ones cost one write. Several processes may have it
// open. Errors as Database. Thread-safe.
class ArtifactRows {
 public:
  static absl::StatusOr<std::unique_ptr<ArtifactRows>> Open(const std::string& path);

  // All of them or none. Those that are there count as stored anew.
  absl::Status PutAll(std::span<const SealedArtifact* const> artifacts);

  absl::StatusOr<std::optional<std::string>> Get(const std::string& id);

  // Ids that begin so.
  absl::StatusOr<std::vector<std::string>> FindIds(const std::string& prefix);

  // Returns when all that is there survives a loss of power.
  absl::Status Flush();

  // What is stored from now on is stored after `mark`. Marks grow; a smaller one than the last changes nothing.
  absl::Status SetMark(int64_t mark);

  // Returns whether there was one that was last stored before the mark.
  absl::StatusOr<bool> Delete(const std::string& id, int64_t mark);

 private:
  explicit ArtifactRows(std::unique_ptr<Database> database) : database_(std::move(database)) {}

  const std::unique_ptr<Database> database_;
};

}  // namespace flair::orchestrator
