// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "orchestrator/batch/lease.h"
#include "orchestrator/store/sqlite_work_queue.h"

namespace flair::orchestrator {

// A run of a job in a store. Every write asks in its own transaction whether the run still holds the job.
class SqliteLease final : public Lease {
 public:
  SqliteLease(SqliteWorkQueue& queue, v1::Job job, std::vector<v1::JobEvent> history, int lost_run_count,
              std::shared_ptr<runtime::Cancellation> cancellation);
  ~SqliteLease() override;

  const v1::Job& job() const override { return job_; }
  const std::vector<v1::JobEvent>& history() const override { return history_; }
  int lost_run_count() const override { return lost_run_count_; }
  // Nothing to do: RecordAll and deletions exclude each other.
  absl::Status Announce(std::span<const StageRecord>) override { return absl::OkStatus(); }
  absl::Status RecordAll(std::span<const StageRecord> records) override;
  absl::Status End(const JobEnd& end) override;
  absl::Status Return(absl::Duration delay, const std::string& reason) override;
  runtime::Cancellation& cancellation() override { return *cancellation_; }
  bool cancel_requested() override;
  bool lost() override { return lost_; }

 private:
  // Makes a change in one transaction; when that fails since one of the artifacts was deleted, settles their deletions.
  absl::Status Write(Transaction::Durability durability, std::span<const StageRecord> records,
                     const std::function<absl::Status()>& change);
  // `changed`: whether the run still held the job. ABORTED when not.
  absl::Status CheckHeld(const absl::StatusOr<bool>& changed);
  // In a transaction of the caller's. ArtifactIsGone when one of the artifacts may have been deleted.
  absl::Status Append(std::span<const StageRecord> records);
  absl::Status CheckNotDeleted(std::span<const StageRecord> records);
  // Turns what waits for its deletion into what was deleted, so that the next run may store it.
  void SettleDeletions(std::span<const StageRecord> records);

  SqliteWorkQueue& queue_;
  JobStore& store_;
  const v1::Job job_;
  const std::vector<v1::JobEvent> history_;
  const int lost_run_count_;
  // Shared with the queue, which cancels it.
  const std::shared_ptr<runtime::Cancellation> cancellation_;
  const JobHold hold_;
  std::atomic<bool> lost_ = false;
  bool done_ = false;
};

}  // namespace flair::orchestrator
