// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/pipeline/replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "orchestrator/pipeline/stage.h"

namespace flair::orchestrator {
namespace {

const Stage& StageAt(int index) { return Stages()[static_cast<size_t>(index)]; }

}  // namespace

int FirstStageOf(const v1::Replay& replay) { return replay.from_stage().empty() ? 0 : StageIndex(replay.from_stage()); }

absl::Status CheckReplay(const v1::JobSpec& spec, JobStore& store) {
  if (!spec.has_replay()) return absl::OkStatus();
  const v1::Replay& replay = spec.replay();
  const int first = FirstStageOf(replay);
  if (first < 0) {
    return absl::InvalidArgumentError(fmt::format("spec.replay.from_stage: there is no stage \"{}\"; one of {}",
                                                  replay.from_stage().substr(0, 80), StageNames()));
  }
  const absl::StatusOr<v1::Job> earlier = store.jobs().Get(replay.job_id());
  if (!earlier.ok()) {
    return absl::Status(earlier.status().code(),
                        fmt::format("spec.replay.{}", std::string(earlier.status().message())));
  }
  if (first == 0) return absl::OkStatus();
  if (AskedBrief(spec) != AskedBrief(earlier->spec())) {
    return absl::InvalidArgumentError(
        fmt::format("spec.brief: is not the brief of job {}, whose \"brief\" is taken; give that brief, or run all "
                    "stages again with spec.replay.from_stage empty",
                    replay.job_id()));
  }
  for (int i = 0; i < first; ++i) {
    const absl::StatusOr<v1::ArtifactRef> ref = ArtifactToTake(replay, i, store.artifacts());
    if (!ref.ok())
      return absl::Status(ref.status().code(), fmt::format("spec.replay: {}", std::string(ref.status().message())));
  }
  return absl::OkStatus();
}

absl::StatusOr<v1::ArtifactRef> ArtifactToTake(const v1::Replay& replay, int stage_index, ArtifactTable& artifacts) {
  const absl::StatusOr<std::vector<v1::ArtifactRef>> refs = artifacts.OfJob(replay.job_id());
  if (!refs.ok()) return refs.status();
  const Stage& stage = StageAt(stage_index);
  const auto found = std::ranges::find(*refs, stage.output, &v1::ArtifactRef::kind);
  if (found != refs->end()) return *found;
  return absl::FailedPreconditionError(
      fmt::format("job {} has no artifact of the stage \"{}\" to take; run it again from \"{}\" or an earlier stage",
                  replay.job_id(), stage.name, stage.name));
}

std::vector<bool> StagesAskedToDiffer(const v1::JobSpec& first, const v1::JobSpec& second) {
  std::vector<bool> differ;
  for (const Stage& stage : Stages()) {
    bool asked = stage.asked != nullptr && stage.asked(first) != stage.asked(second);
    for (size_t i = 0; i < differ.size(); ++i) {
      asked |= differ[i] && std::ranges::find(stage.inputs, StageAt(static_cast<int>(i)).output) != stage.inputs.end();
    }
    differ.push_back(asked);
  }
  return differ;
}

}  // namespace flair::orchestrator
