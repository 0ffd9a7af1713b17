// SPDX-License-Identifier: GPL-3.0-or-later
// Jobs that run an earlier job again; see Replay in job.proto.
#pragma once

#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "flair/v1/job.pb.h"
#include "orchestrator/batch/work_queue.h"

namespace flair::orchestrator {

// Index of the first stage that a replay runs. The stage must be known (CheckReplay).
int FirstStageOf(const v1::Replay& replay);

// Says whether a job can replay `earlier`, the job that it names: INVALID_ARGUMENT for a stage that there is not and
// for another brief than that job's where its brief is taken, FAILED_PRECONDITION when that job did not come so far.
absl::Status CheckReplay(const v1::JobSpec& spec, const v1::Job& earlier);

// Names the earlier job's artifact of a stage. FAILED_PRECONDITION when it has none.
absl::StatusOr<v1::ArtifactRef> ArtifactToTake(const v1::Replay& replay, int stage_index, WorkQueue& queue);
absl::StatusOr<v1::ArtifactRef> ArtifactToTake(const v1::Replay& replay, int stage_index, const v1::Job& earlier);

// For each stage whether the specs ask for another result of it, of itself or because one of its inputs is another.
std::vector<bool> StagesAskedToDiffer(const v1::JobSpec& first, const v1::JobSpec& second);

}  // namespace flair::orchestrator
