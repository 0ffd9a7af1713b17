// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "flair/store/v1/job_record.pb.h"
#include "orchestrator/batch/work_queue.h"
#include "orchestrator/store/database.h"

namespace flair::orchestrator {

// Queries about batches, and the order in which their jobs ended. Each call is one step for other processes; to join
// several, hold a Transaction. Thread-safe.
class BatchTable {
 public:
  explicit BatchTable(Database& database) : database_(database) {}

  // ALREADY_EXISTS when the id or the request id is taken.
  absl::Status Insert(const store::v1::BatchRecord& record);

  // The batch that a request made; nothing when none.
  absl::StatusOr<std::optional<store::v1::BatchRecord>> FindByRequest(const std::string& request_id);

  // Without counts by state. NOT_FOUND when unknown.
  absl::StatusOr<v1::Batch> Get(const std::string& id);

  // With the counts of its jobs.
  absl::StatusOr<v1::Batch> GetWithCounts(const std::string& id);

  // Newest first, without counts by state.
  absl::StatusOr<std::vector<v1::Batch>> List(const ListFilter& filter);

  absl::Status SetState(const std::string& id, v1::BatchState state);
  absl::Status SetJobs(const std::string& id, int64_t job_count, bool open);

  // Puts the end of a job behind all others; forgets it.
  absl::Status AddEnd(const std::string& batch_id, const std::string& job_id);
  absl::Status RemoveEnd(const std::string& job_id);
  absl::StatusOr<std::vector<BatchEnd>> EndsAfter(const std::string& batch_id, int64_t sequence, int limit);

 private:
  Database& database_;
};

}  // namespace flair::orchestrator
