// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/pipeline/stage.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "orchestrator/store/artifact_id.h"
#include "room/validation/validate.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

// Optimizers of more revisions than this are not at work at once.
constexpr size_t kCatalogsKept = 4;

}  // namespace

absl::StatusOr<std::shared_ptr<const SharedCatalog>> CatalogCache::Get(StageClients& clients, StageCall& call) {
  ASSIGN_OR_RETURN(const std::optional<std::string> revision, clients.Revision(v1::ARTIFACT_KIND_SOLVED_LAYOUT, call));
  if (revision.has_value()) {
    std::lock_guard lock(mutex_);
    if (const auto known = catalogs_.find(*revision); known != catalogs_.end()) return known->second;
  }
  ASSIGN_OR_RETURN(auto response, clients.ListConstraintTypes({}, call));
  const auto asked = std::make_shared<SharedCatalog>();
  asked->catalog = std::move(*response.mutable_catalog());
  asked->digest = runtime::Sha256Hex(runtime::CanonicalBytes(asked->catalog));
  // Another one than was thought of may have answered, or one that does not say which it is.
  if (call.answerer().has_value() && call.answerer()->revision.has_value()) {
    std::lock_guard lock(mutex_);
    if (catalogs_.size() >= kCatalogsKept) catalogs_.clear();
    catalogs_[*call.answerer()->revision] = asked;
  }
  return asked;
}

absl::Status CheckAnswer(const Stage& stage, const v1::Artifact& artifact) {
  if (KindOf(artifact) != stage.output) {
    return absl::InternalError(
        fmt::format("stage \"{}\": the worker's answer has no {}", stage.name, v1::ArtifactKind_Name(stage.output)));
  }
  absl::Status status = Validate(artifact);
  const v1::SolvedLayout& layout = artifact.solved_layout();
  if (status.ok() && layout.placements().empty() && !layout.graph().object_list().objects().empty()) {
    status = absl::InvalidArgumentError("solved_layout.placements: there are none, of objects that there are");
  }
  if (status.ok()) return status;
  const std::string& program = artifact.producer().program();
  return absl::InternalError(fmt::format("stage \"{}\": the answer of {} is not valid: {}", stage.name,
                                         program.empty() ? "a worker that does not name itself" : program,
                                         std::string(status.message())));
}

int StageIndex(std::string_view name) {
  const std::span<const Stage> stages = Stages();
  for (size_t i = 0; i < stages.size(); ++i) {
    if (stages[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

std::string StageNames() {
  std::string names;
  for (const Stage& stage : Stages()) names += (names.empty() ? "" : ", ") + std::string(stage.name);
  return names;
}

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
  ASSIGN_OR_RETURN(const v1::Job earlier, queue.GetJob(replay.job_id()));
  return ArtifactToTake(replay, stage_index, earlier);
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
