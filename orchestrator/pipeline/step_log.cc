// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/pipeline/step_log.h"

#include <utility>

namespace flair::orchestrator {
namespace {

// Work of a job that a crash may take with it, beside the stages that run. A write takes less than a hundredth of it.
constexpr absl::Duration kWorkKeptBack = absl::Milliseconds(500);

}  // namespace

absl::Status StepLog::Add(StageRecord record, std::optional<SealedArtifact> artifact, Urgency urgency) {
  const google::protobuf::Duration& took = record.event.duration();
  std::lock_guard lock(mutex_);
  work_ += absl::Seconds(took.seconds()) + absl::Nanoseconds(took.nanos());
  kept_.push_back(std::move(record));
  if (artifact.has_value()) kept_artifacts_.push_back(*std::move(artifact));
  return urgency == Urgency::kAtOnce || work_ > kWorkKeptBack ? StoreKept() : absl::OkStatus();
}

absl::Status StepLog::Store() {
  std::lock_guard lock(mutex_);
  return StoreKept();
}

absl::StatusOr<std::vector<StageRecord>> StepLog::TakeLast() {
  std::lock_guard lock(mutex_);
  return TakeKept();
}

// What is recorded is there: first the artifacts.
absl::StatusOr<std::vector<StageRecord>> StepLog::TakeKept() {
  work_ = absl::ZeroDuration();
  std::vector<StageRecord> records = std::exchange(kept_, {});
  // Nobody deletes what is stored before it is recorded.
  if (absl::Status status = lease_.Announce(records); !status.ok()) return status;
  if (absl::Status status = artifacts_.PutAll(std::exchange(kept_artifacts_, {})); !status.ok()) return status;
  return records;
}

absl::Status StepLog::StoreKept() {
  const absl::StatusOr<std::vector<StageRecord>> records = TakeKept();
  return records.ok() ? lease_.RecordAll(*records) : records.status();
}

}  // namespace flair::orchestrator
