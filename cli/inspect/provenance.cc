// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/inspect/provenance.h"

#include <algorithm>
#include <functional>

#include "cli/input/artifact_file.h"
#include "cli/output/artifact_text.h"
#include "orchestrator/store/artifact_id.h"

namespace flair::cli {
namespace {

std::string NameOf(v1::ArtifactKind kind) {
  const std::string stem = FileStem(kind);
  return stem.empty() ? KindName(kind) : stem;
}

ProvenanceStep StepOf(const v1::Artifact& artifact, const std::string& place) {
  const v1::ArtifactKind kind = orchestrator::KindOf(artifact);
  ProvenanceStep step;
  step.id = artifact.id();
  step.name = NameOf(kind);
  step.place = place;
  step.stage = StageOf(kind);
  step.made_from_ids.assign(artifact.made_from_ids().begin(), artifact.made_from_ids().end());
  step.producer = artifact.producer();
  step.options_digest = artifact.options_digest();
  step.edited = IsEdited(artifact);
  if (artifact.has_brief()) {
    step.text = artifact.brief().text();
    step.seeds.push_back(artifact.brief().seed());
  }
  for (const v1::StageOutcome& stage : artifact.solved_layout().stage_outcomes()) {
    if (std::find(step.seeds.begin(), step.seeds.end(), stage.seed()) == step.seeds.end()) {
      step.seeds.push_back(stage.seed());
    }
  }
  for (const v1::ModelCall& call : artifact.model_calls()) {
    step.models.insert(call.model());
    step.prompt_versions.insert(call.prompt_version());
  }
  step.model_call_count = artifact.model_calls_size();
  return step;
}

}  // namespace

std::vector<ProvenanceStep> FindProvenance(const v1::Artifact& artifact, ArtifactFinder& finder, size_t most) {
  std::vector<ProvenanceStep> steps;
  std::set<std::string> seen;
  const std::function<void(const v1::Artifact&, const std::string&)> add = [&](const v1::Artifact& of,
                                                                               const std::string& place) {
    seen.insert(of.id());
    for (const std::string& id : of.made_from_ids()) {
      if (seen.contains(id)) continue;
      if (seen.size() >= most) break;
      if (const std::optional<ArtifactFinder::Found> found = finder.Find(id)) {
        add(found->artifact, found->place);
      } else {
        seen.insert(id);
        ProvenanceStep missing;
        missing.id = id;
        steps.push_back(std::move(missing));
      }
    }
    steps.push_back(StepOf(of, place));
  };
  add(artifact, "here");
  return steps;
}

}  // namespace flair::cli
