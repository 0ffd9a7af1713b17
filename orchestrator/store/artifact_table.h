// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "flair/v1/artifact.pb.h"
#include "flair/v1/job.pb.h"
#include "orchestrator/store/database.h"

namespace flair::orchestrator {

// A job that has artifacts.
struct ArtifactHolder {
  ArtifactHolder(const v1::Job& job);  // NOLINT(google-explicit-constructor): a job is one.
  std::string job_id;
  // See BriefDigest.
  std::string brief;
  std::string caller;
};

// Which artifacts belong to which job, and what a stage made of given inputs before. Thread-safe.
class ArtifactTable {
 public:
  explicit ArtifactTable(Database& database) : database_(database) {}

  // In stage order.
  absl::StatusOr<std::vector<v1::ArtifactRef>> OfJob(const std::string& job_id);

  // Replaces what the stage had.
  absl::Status Attach(const ArtifactHolder& holder, int stage_index, const v1::ArtifactRef& artifact);

  // What was made of a brief under a key of ResultKey(); nothing when nothing was.
  absl::StatusOr<std::optional<v1::ArtifactRef>> FindResult(const std::string& brief, const std::string& key);
  // Whether there is any for the brief.
  absl::StatusOr<bool> HasResults(const std::string& brief);

  // The latest result wins.
  absl::Status SetResult(const std::string& brief, const std::string& key, const v1::ArtifactRef& artifact);

 private:
  Database& database_;
};

}  // namespace flair::orchestrator
