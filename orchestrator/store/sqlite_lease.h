// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <span>
#include <vector>

#include "orchestrator/batch/lease.h"
#include "orchestrator/store/sqlite_work_queue.h"

namespace flair::orchestrator {

// A run of a job in a store. Every write asks in its own transaction whether the run still holds the job.
class SqliteLease final : public Lease {
 public:
  SqliteLease(SqliteWorkQueue& queue, v1::Job job, std::vector<v1::JobEvent> history,
              std::shared_ptr<runtime::Cancellation> cancellation);
  ~SqliteLease() override;

  const v1::Job& job() const override { return job_; }
  const std::vector<v1::JobEvent>& history() const override { return history_; }
  absl::Status RecordAll(std::span<const StageRecord> records) override;
  absl::Status End(const JobEnd& end) override;
  absl::Status Return(absl::Duration delay, const std::string& reason) override;
  runtime::Cancellation& cancellation() override { return *cancellation_; }
  bool cancel_requested() override;
  bool lost() override { return lost_; }

 private:
  // `changed`: whether the run still held the job. ABORTED when not.
  absl::Status CheckHeld(const absl::StatusOr<bool>& changed);
  // In a transaction of the caller's.
  absl::Status Append(std::span<const StageRecord> records);

  SqliteWorkQueue& queue_;
  JobStore& store_;
  const v1::Job job_;
  const std::vector<v1::JobEvent> history_;
  // Shared with the queue, which cancels it.
  const std::shared_ptr<runtime::Cancellation> cancellation_;
  const JobHold hold_;
  std::atomic<bool> lost_ = false;
  bool done_ = false;
};

}  // namespace flair::orchestrator
