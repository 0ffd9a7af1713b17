// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/v1/job.pb.h"
#include "orchestrator/store/database.h"

namespace flair::orchestrator {

// Queries about jobs. Each call is one step for other processes; to join several, hold a Transaction. A Job read here
// has its artifacts too. Thread-safe.
class JobTable {
 public:
  explicit JobTable(Database& database) : database_(database) {}

  // A new QUEUED job; `request_id` empty for a job of a batch. ALREADY_EXISTS when its id or request id is taken.
  absl::Status Insert(const v1::Job& job, const std::string& request_id);

  // NOT_FOUND when unknown.
  absl::StatusOr<v1::Job> Get(const std::string& id);

  // Id of the job that a request made; empty when none.
  absl::StatusOr<std::string> FindByRequest(const std::string& request_id);

  // Jobs with ids below `before` (all when empty), newest first; of one batch when `batch_id` is set.
  absl::StatusOr<std::vector<v1::Job>> List(int limit, const std::string& before, const std::string& batch_id);

  // Jobs QUEUED.
  absl::StatusOr<int64_t> CountQueued();

  // Makes the oldest QUEUED job RUNNING by `owner`; nothing when none waits.
  absl::StatusOr<std::optional<std::string>> ClaimOldest(const std::string& owner);

  // The same for one job; false when it is not QUEUED.
  absl::StatusOr<bool> Claim(const std::string& id, const std::string& owner);

  // Owners of RUNNING jobs.
  absl::StatusOr<std::vector<std::string>> Owners();

  // Makes the RUNNING jobs of a dead owner QUEUED again.
  absl::Status Release(const std::string& owner);

  // Makes one RUNNING job QUEUED again.
  absl::Status ReleaseOne(const std::string& id);

  absl::Status SetStage(const std::string& id, const std::string& stage);

  // Ends a job with job.state(), error and end_time.
  absl::Status End(const v1::Job& job);

  // Remembers that somebody wants the job to end.
  absl::Status RequestCancel(const std::string& id);
  absl::StatusOr<bool> CancelRequested(const std::string& id);

 private:
  absl::StatusOr<v1::Job> Read(Statement& row);

  Database& database_;
};

}  // namespace flair::orchestrator
