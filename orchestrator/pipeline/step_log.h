// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>
#include <optional>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "orchestrator/batch/artifact_store.h"
#include "orchestrator/batch/lease.h"

namespace flair::orchestrator {

// What the stages of one run do, with the artifacts that they make, on its way into the store and the queue. A write
// there costs as much as many a stage, so steps that took next to no time are kept back until they are worth one, or
// until the next step that is or the end of the job. A process that is killed takes at most that much work with it,
// which the next run makes again, to the byte. The arguments outlive it. Thread-safe.
class StepLog {
 public:
  enum class Urgency { kMayWait, kAtOnce };

  StepLog(Lease& lease, ArtifactStore& artifacts) : lease_(lease), artifacts_(artifacts) {}

  // Stores the step together with those kept back, or keeps it back too. Errors as ArtifactStore::PutAll and
  // Lease::RecordAll; then none of them is recorded, nor tried again.
  absl::Status Add(StageRecord record, std::optional<SealedArtifact> artifact, Urgency urgency);

  // Stores what was kept back.
  absl::Status Store();

  // Stores the artifacts that were kept back and gives away what is to be recorded, for the job's end.
  absl::StatusOr<std::vector<StageRecord>> TakeLast();

 private:
  // With mutex_ held.
  absl::StatusOr<std::vector<StageRecord>> TakeKept();
  absl::Status StoreKept();

  Lease& lease_;
  ArtifactStore& artifacts_;
  std::mutex mutex_;
  std::vector<StageRecord> kept_;
  std::vector<SealedArtifact> kept_artifacts_;
  // Of the steps kept back, together.
  absl::Duration work_;
};

}  // namespace flair::orchestrator
