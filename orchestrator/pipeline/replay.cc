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

absl::Status CheckReplay(const v1::JobSpec& spec, const v1::Job& earlier) {
  const v1::Replay& replay = spec.replay();
  const int first = FirstStageOf(replay);
  if (first < 0) {
    return absl::InvalidArgumentError(fmt::format("spec.replay.from_stage: there is no stage \"{}\"; one of {}",
                                                  replay.from_stage().substr(0, 80), StageNames()));
  }
  if (first == 0) return absl::OkStatus();
  if (AskedBrief(spec) != AskedBrief(earlier.spec())) {
    return absl::InvalidArgumentError(
        fmt::format("spec.brief: is not the brief of job {}, whose \"brief\" is taken; give that brief, or run all "
                    "stages again with spec.replay.from_stage empty",
                    replay.job_id()));
  }
  for (int i = 0; i < first; ++i) {
    const absl::StatusOr<v1::ArtifactRef> ref = ArtifactToTake(replay, i, earlier);
    if (!ref.ok())
      return absl::Status(ref.status().code(), fmt::format("spec.replay: {}", std::string(ref.status().message())));
  }
  return absl::OkStatus();
}

absl::StatusOr<v1::ArtifactRef> ArtifactToTake(const v1::Replay& replay, int stage_index, WorkQueue& queue) {
  const absl::StatusOr<v1::Job> earlier = queue.GetJob(replay.job_id());
  if (!earlier.ok()) return earlier.status();
  return ArtifactToTake(replay, stage_index, *earlier);
}

absl::StatusOr<v1::ArtifactRef> ArtifactToTake(const v1::Replay& replay, int stage_index, const v1::Job& earlier) {
  const Stage& stage = StageAt(stage_index);
  // Several stages may make the same kind, in their order.
  auto before = std::ranges::count(Stages().first(static_cast<size_t>(stage_index)), stage.output, &Stage::output);
  for (const v1::ArtifactRef& ref : earlier.artifacts()) {
    if (ref.kind() == stage.output && before-- == 0) return ref;
  }
  return absl::FailedPreconditionError(
      fmt::format("job {} has no artifact of the stage \"{}\" to take; run it again from \"{}\" or an earlier stage",
                  replay.job_id(), stage.name, stage.name));
}

std::vector<bool> StagesAskedToDiffer(const v1::JobSpec& first, const v1::JobSpec& second) {
  std::vector<bool> differ;
  for (const Stage& stage : Stages()) {
    if (stage.wanted != nullptr && !stage.wanted(first) && !stage.wanted(second)) {
      differ.push_back(false);
      continue;
    }
    bool asked = stage.asked != nullptr && stage.asked(first) != stage.asked(second);
    for (size_t i = 0; i < differ.size(); ++i) {
      asked |= differ[i] && std::ranges::find(stage.inputs, StageAt(static_cast<int>(i)).output) != stage.inputs.end();
    }
    differ.push_back(asked);
  }
  return differ;
}

}  // namespace flair::orchestrator
