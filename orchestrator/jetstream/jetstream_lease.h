// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "orchestrator/batch/lease.h"
#include "orchestrator/jetstream/artifact_users.h"
#include "orchestrator/jetstream/job_ends.h"
#include "orchestrator/jetstream/lease_keeper.h"
#include "orchestrator/jetstream/queue_parts.h"

namespace flair::orchestrator {

// A run of a job of a queue in JetStream. Every write replaces the record as this run knows it, so that it fails when
// another run has changed it. Writes go on through times without an answer for as long as the hold lasts.
class JetStreamLease final : public Lease {
 public:
  // `record` says that `hold` has the job. `parts`, `ends` and `keeper` outlive it.
  JetStreamLease(QueueParts& parts, JobEnds& ends, LeaseKeeper& keeper, std::shared_ptr<Hold> hold, RevisedJob record);
  ~JetStreamLease() override;

  const v1::Job& job() const override { return job_; }
  const std::vector<v1::JobEvent>& history() const override { return history_; }
  int lost_run_count() const override { return lost_run_count_; }
  absl::Status Announce(std::span<const StageRecord> records) override;
  absl::Status RecordAll(std::span<const StageRecord> records) override;
  absl::Status End(const JobEnd& end) override;
  absl::Status Return(absl::Duration delay, const std::string& reason) override;
  runtime::Cancellation& cancellation() override { return hold_->cancellation; }
  bool cancel_requested() override { return hold_->cancel_requested; }
  bool lost() override { return hold_->lost; }

 private:
  absl::Status Write(const std::function<void(store::v1::JobRecord&)>& change, const std::function<bool()>& more);
  absl::Status Close(const std::function<void(store::v1::JobRecord&)>& change, const std::function<bool()>& more);
  absl::Status ReadAgain();
  absl::Status Refused();
  absl::Status BecomeUser(std::span<const StageRecord> records);
  absl::Status Index(std::span<const StageRecord> records);

  QueueParts& parts_;
  JobEnds& ends_;
  LeaseKeeper& keeper_;
  // Shared with the keeper.
  const std::shared_ptr<Hold> hold_;
  const v1::Job job_;
  const std::vector<v1::JobEvent> history_;
  const int lost_run_count_;
  ArtifactUsers users_;

  std::mutex mutex_;
  RevisedJob record_;
  // Artifacts that this run uses.
  std::set<std::string> used_;
  bool done_ = false;
};

}  // namespace flair::orchestrator
