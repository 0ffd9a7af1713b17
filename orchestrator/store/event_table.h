// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "flair/v1/job.pb.h"
#include "orchestrator/store/database.h"

namespace flair::orchestrator {

// What happened to each job. Thread-safe.
class EventTable {
 public:
  explicit EventTable(Database& database) : database_(database) {}

  // Stores the event under the job's next sequence number, which it is given. In a Transaction when several processes
  // may write events of the job.
  absl::Status Append(v1::JobEvent& event);

  // The two halves of it, for several events in one Transaction. 0 when there is none.
  absl::StatusOr<int64_t> LastSequence(const std::string& job_id);
  absl::Status Insert(const v1::JobEvent& event);

  // At most `limit` events after a sequence number, in order.
  absl::StatusOr<std::vector<v1::JobEvent>> After(const std::string& job_id, int64_t sequence, int limit);

 private:
  Database& database_;
};

}  // namespace flair::orchestrator
