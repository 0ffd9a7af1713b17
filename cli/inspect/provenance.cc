// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/inspect/provenance.h"

#include <algorithm>
#include <functional>
#include <map>

#include "cli/input/artifact_file.h"
#include "cli/output/artifact_text.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "nlohmann/json.hpp"
#include "orchestrator/store/artifact_id.h"
#include "worker_runtime/text/counted.h"

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

namespace {

constexpr size_t kShortDigits = 12;

std::string Short(const std::string& digest) { return digest.substr(0, kShortDigits); }

// "graph", with digits of its id when several have the name; digits alone for what was not found.
std::map<std::string, std::string> NamesOf(const std::vector<ProvenanceStep>& steps) {
  std::map<std::string, int> count;
  for (const ProvenanceStep& step : steps) ++count[step.name];
  std::map<std::string, std::string> names;
  for (const ProvenanceStep& step : steps) {
    names[step.id] = step.name.empty()      ? Short(step.id) + " (missing)"
                     : count[step.name] > 1 ? step.name + " " + Short(step.id)
                                            : step.name;
  }
  return names;
}

std::string MakerText(const ProvenanceStep& step) {
  const v1::Producer& producer = step.producer;
  std::string text = step.edited ? "edited by hand" : fmt::format("{}, {}", producer.program(), producer.method());
  if (producer.program().empty()) text = "nobody says who made it";
  if (!producer.version().empty()) text += fmt::format(", {}{}", step.edited ? "" : "version ", producer.version());
  if (!producer.build().empty()) text += ", build " + producer.build();
  if (!producer.configuration_digest().empty()) text += ", configuration " + Short(producer.configuration_digest());
  return text;
}

// What decided it beside its inputs; empty when nothing did.
std::string ChoicesText(const ProvenanceStep& step) {
  std::vector<std::string> parts;
  if (!step.options_digest.empty()) parts.push_back("options " + Short(step.options_digest));
  if (!step.seeds.empty()) {
    parts.push_back(fmt::format("{} {}", step.seeds.size() == 1 ? "seed" : "seeds", fmt::join(step.seeds, ", ")));
  }
  if (step.model_call_count > 0) {
    parts.push_back(fmt::format("{} of {}, prompts {}", Counted(step.model_call_count, "call"),
                                fmt::join(step.models, ", "), fmt::join(step.prompt_versions, ", ")));
  }
  return fmt::format("{}", fmt::join(parts, "; "));
}

}  // namespace

std::string ProvenanceText(const std::vector<ProvenanceStep>& steps, const std::string& places) {
  const std::map<std::string, std::string> names = NamesOf(steps);
  std::string text;
  for (const ProvenanceStep& step : steps) {
    if (step.name.empty()) {
      text += fmt::format("{:<15} {}  MISSING: {}\n", "?", Short(step.id), places);
      continue;
    }
    text += fmt::format("{:<15} {}  stage {}, {}\n", step.name, Short(step.id), step.stage, step.place);
    if (!step.text.empty()) text += fmt::format("{:<15} \"{}\"\n", "", Shortened(step.text, 90));
    text += fmt::format("{:<15} {}\n", "", MakerText(step));
    if (const std::string choices = ChoicesText(step); !choices.empty())
      text += fmt::format("{:<15} {}\n", "", choices);
    if (step.made_from_ids.empty()) continue;
    std::vector<std::string> parents;
    for (const std::string& id : step.made_from_ids) {
      const auto found = names.find(id);
      parents.push_back(found == names.end() ? Short(id) : found->second);
    }
    text += fmt::format("{:<15} from {}\n", "", fmt::join(parents, ", "));
  }
  return text;
}

std::string ProvenanceJson(const std::vector<ProvenanceStep>& steps) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const ProvenanceStep& step : steps) {
    nlohmann::ordered_json entry = {{"id", step.id}, {"found", !step.name.empty()}};
    if (!step.name.empty()) {
      entry["kind"] = step.name;
      entry["place"] = step.place;
      entry["stage"] = step.stage;
      entry["program"] = step.producer.program();
      entry["method"] = step.producer.method();
      entry["version"] = step.producer.version();
      entry["build"] = step.producer.build();
      entry["configuration_digest"] = step.producer.configuration_digest();
      entry["options_digest"] = step.options_digest;
      entry["edited"] = step.edited;
      entry["made_from_ids"] = step.made_from_ids;
      entry["seeds"] = step.seeds;
      entry["models"] = step.models;
      entry["prompt_versions"] = step.prompt_versions;
      if (!step.text.empty()) entry["text"] = step.text;
    }
    json.push_back(std::move(entry));
  }
  return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string ProvenanceLine(const std::vector<ProvenanceStep>& steps) {
  std::vector<std::string> names;
  size_t missing = 0;
  for (const ProvenanceStep& step : steps) {
    missing += step.name.empty() ? 1 : 0;
    if (!step.name.empty()) names.push_back(step.edited ? step.name + " (edited)" : step.name);
  }
  std::string text = fmt::format("{}", fmt::join(names, " > "));
  if (missing > 0) text += fmt::format("; {} missing", missing);
  return text;
}

}  // namespace flair::cli
