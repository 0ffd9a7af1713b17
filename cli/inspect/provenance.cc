// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/inspect/provenance.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "cli/input/artifact_file.h"
#include "cli/output/artifact_text.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "nlohmann/json.hpp"
#include "orchestrator/store/artifact_id.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {

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
        steps.push_back({.id = id});
      }
    }
    steps.push_back({.id = of.id(), .place = place, .artifact = of});
  };
  add(artifact, "here");
  return steps;
}

namespace {

std::string Short(const std::string& digest) { return digest.substr(0, 12); }

// What decided it beside its inputs.
struct Choices {
  std::vector<int64_t> seeds = {};             // of a brief, or of the solve of a layout
  std::set<std::string> models = {};           // that were asked for it
  std::set<std::string> prompt_versions = {};  // of the questions
};

Choices ChoicesOf(const v1::Artifact& artifact) {
  Choices choices;
  if (artifact.has_brief()) choices.seeds.push_back(artifact.brief().seed());
  for (const v1::StageOutcome& stage : artifact.solved_layout().stage_outcomes()) {
    if (std::ranges::find(choices.seeds, stage.seed()) == choices.seeds.end()) choices.seeds.push_back(stage.seed());
  }
  for (const v1::ModelCall& call : artifact.model_calls()) {
    choices.models.insert(call.model());
    choices.prompt_versions.insert(call.prompt_version());
  }
  return choices;
}

std::string ChoicesText(const v1::Artifact& artifact) {
  const Choices choices = ChoicesOf(artifact);
  std::vector<std::string> parts;
  if (!artifact.options_digest().empty()) parts.push_back("options " + Short(artifact.options_digest()));
  if (!choices.seeds.empty()) {
    parts.push_back(
        fmt::format("{} {}", Form(std::ssize(choices.seeds), "seed", "seeds"), fmt::join(choices.seeds, ", ")));
  }
  if (!artifact.model_calls().empty()) {
    parts.push_back(fmt::format("{} of {}, prompts {}", Counted(artifact.model_calls_size(), "call"),
                                fmt::join(choices.models, ", "), fmt::join(choices.prompt_versions, ", ")));
  }
  return fmt::format("{}", fmt::join(parts, "; "));
}

// "graph", with digits of its id when several have the name; digits alone for what was not found.
std::map<std::string, std::string> NamesOf(const std::vector<ProvenanceStep>& steps) {
  std::map<std::string, int> count;
  for (const ProvenanceStep& step : steps) ++count[NameOf(step)];
  std::map<std::string, std::string> names;
  for (const ProvenanceStep& step : steps) {
    const std::string name = NameOf(step);
    names[step.id] = name.empty()      ? Short(step.id) + " (missing)"
                     : count[name] > 1 ? name + " " + Short(step.id)
                                       : name;
  }
  return names;
}

}  // namespace

std::string NameOf(const ProvenanceStep& step) {
  if (!step.artifact) return "";
  const v1::ArtifactKind kind = orchestrator::KindOf(*step.artifact);
  const std::string stem = FileStem(kind);
  return stem.empty() ? KindName(kind) : stem;
}

std::string MakerText(const v1::Artifact& artifact) {
  const v1::Producer& producer = artifact.producer();
  std::string text =
      IsEdited(artifact) ? "edited by hand" : fmt::format("{}, {}", producer.program(), producer.method());
  if (producer.program().empty()) text = "nobody says who made it";
  if (!producer.version().empty()) {
    text += fmt::format(", {}{}", IsEdited(artifact) ? "" : "version ", producer.version());
  }
  if (!producer.build().empty()) text += ", build " + producer.build();
  return text;
}

std::string ProvenanceText(const std::vector<ProvenanceStep>& steps, const std::string& places) {
  const std::map<std::string, std::string> names = NamesOf(steps);
  std::string text;
  const auto line = [&text](const std::string& words) { text += fmt::format("{:<15} {}\n", "", words); };
  for (const ProvenanceStep& step : steps) {
    if (!step.artifact) {
      text += fmt::format("{:<15} {}  MISSING: {}\n", "?", Short(step.id), places);
      continue;
    }
    const v1::Artifact& artifact = *step.artifact;
    text += fmt::format("{:<15} {}  stage {}, {}\n", NameOf(step), Short(step.id),
                        StageOf(orchestrator::KindOf(artifact)), step.place);
    if (artifact.has_brief()) line(fmt::format("\"{}\"", Shortened(artifact.brief().text(), 90)));
    const std::string& configuration = artifact.producer().configuration_digest();
    line(MakerText(artifact) + (configuration.empty() ? "" : ", configuration " + Short(configuration)));
    if (const std::string choices = ChoicesText(artifact); !choices.empty()) line(choices);
    std::vector<std::string> parents;
    for (const std::string& id : artifact.made_from_ids()) {
      const auto found = names.find(id);
      parents.push_back(found == names.end() ? Short(id) : found->second);
    }
    if (!parents.empty()) line(fmt::format("from {}", fmt::join(parents, ", ")));
  }
  return text;
}

std::string ProvenanceJson(const std::vector<ProvenanceStep>& steps) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const ProvenanceStep& step : steps) {
    nlohmann::ordered_json entry = {{"id", step.id}, {"found", step.artifact.has_value()}};
    if (step.artifact) {
      const v1::Artifact& artifact = *step.artifact;
      const v1::Producer& producer = artifact.producer();
      const Choices choices = ChoicesOf(artifact);
      entry.update({{"kind", NameOf(step)},
                    {"place", step.place},
                    {"stage", StageOf(orchestrator::KindOf(artifact))},
                    {"program", producer.program()},
                    {"method", producer.method()},
                    {"version", producer.version()},
                    {"build", producer.build()},
                    {"configuration_digest", producer.configuration_digest()},
                    {"options_digest", artifact.options_digest()},
                    {"edited", IsEdited(artifact)},
                    {"made_from_ids", std::vector(artifact.made_from_ids().begin(), artifact.made_from_ids().end())},
                    {"seeds", choices.seeds},
                    {"models", choices.models},
                    {"prompt_versions", choices.prompt_versions}});
      if (artifact.has_brief()) entry["text"] = artifact.brief().text();
    }
    json.push_back(std::move(entry));
  }
  return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string ProvenanceLine(const std::vector<ProvenanceStep>& steps) {
  std::vector<std::string> names;
  for (const ProvenanceStep& step : steps) {
    if (step.artifact) names.push_back(NameOf(step) + (IsEdited(*step.artifact) ? " (edited)" : ""));
  }
  std::string text = fmt::format("{}", fmt::join(names, " > "));
  if (names.size() < steps.size()) text += fmt::format("; {} missing", steps.size() - names.size());
  return text;
}

}  // namespace flair::cli
