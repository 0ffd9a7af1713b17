// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/inspect/inspection.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "cli/output/artifact_text.h"
#include "cli/output/message_view.h"
#include "cli/output/report_text.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "google/protobuf/util/time_util.h"
#include "nlohmann/json.hpp"
#include "orchestrator/pipeline/stage.h"
#include "orchestrator/store/artifact_id.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

// "made by    somebody"; nothing for nothing.
std::string Line(const char* title, const std::string& value) {
  return value.empty() ? "" : fmt::format("{:<11}{}\n", title, value);
}

std::string IdText(const ArtifactFile& file) {
  const std::string id = file.edited || file.whole.ok() ? file.artifact.id() : file.stated_id;
  if (!file.whole.ok()) return fmt::format("{} (does NOT match its bytes: corrupt)", id);
  if (!file.edited) return fmt::format("{} (matches its bytes)", id);
  return fmt::format("{} (of its bytes; {})", id,
                     file.stated_id.empty() ? "the file states none" : "changed since it was " + file.stated_id);
}

std::string MakerLine(const v1::Artifact& artifact) {
  const v1::Producer& producer = artifact.producer();
  if (!IsEdited(artifact)) return producer.program().empty() ? "" : Line("made by", MakerText(artifact));
  return Line("edited by",
              "hand, " + (producer.version().empty() ? "the producer of the original is unknown" : producer.version()));
}

std::string OriginLines(const v1::Artifact& artifact, ArtifactFinder& finder) {
  if (artifact.made_from_ids().empty()) return "";
  const std::vector<ProvenanceStep> steps = FindProvenance(artifact, finder);
  std::string text;
  for (int i = 0; i < artifact.made_from_ids_size(); ++i) {
    const std::string& id = artifact.made_from_ids(i);
    std::string name = finder.FileBeside(id);
    for (const ProvenanceStep& step : steps) {
      if (name.empty() && step.id == id) name = step.artifact ? NameOf(step) : "not found";
    }
    text += Line(i == 0 ? "made from" : "", fmt::format("{}  {}", id, name));
  }
  return text + Line("the way", ProvenanceLine(steps));
}

// The list that a cleaned one was made from.
std::optional<ArtifactFinder::Found> FindRaw(const v1::Artifact& artifact, ArtifactFinder& finder) {
  if (!artifact.has_constraint_list()) return std::nullopt;
  for (const std::string& id : artifact.made_from_ids()) {
    std::optional<ArtifactFinder::Found> found = finder.Find(id);
    if (found && found->artifact.has_raw_constraint_list()) return found;
  }
  return std::nullopt;
}

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

std::string InspectionText(const std::string& name, const ArtifactFile& file, ArtifactFinder& finder,
                           size_t most_rows) {
  const v1::Artifact& artifact = file.artifact;
  std::string text =
      Line("what", fmt::format("{}: {}", KindName(orchestrator::KindOf(artifact)), orchestrator::Summarize(artifact))) +
      Line("id", IdText(file)) + MakerLine(artifact) + Line("configured", artifact.producer().configuration_digest()) +
      Line("options", artifact.options_digest()) + OriginLines(artifact, finder);
  if (const std::string models = orchestrator::SummarizeModels(artifact); !models.empty()) {
    text += Line("model", models) + ModelCallLines(artifact);
  }
  if (!file.good.ok()) text += fmt::format("\nNOT VALID\n{}\n", std::string(file.good.message()));
  const std::optional<ArtifactFinder::Found> raw = FindRaw(artifact, finder);
  const std::string content = ContentText(artifact, raw ? &raw->artifact.raw_constraint_list() : nullptr, most_rows);
  text += (content.starts_with('\n') ? "" : "\n") + content;
  return text + "\n" +
         Line("more", fmt::format("flair inspect {} --provenance | --field PATH | --format json | --format textproto{}",
                                  name, artifact.model_calls().empty() ? "" : " | --calls"));
}

std::string ReplayText(const v1::Job& job) {
  if (!job.spec().has_replay()) return "";
  const v1::Replay& replay = job.spec().replay();
  return replay.job_id() + (replay.from_stage().empty() ? "" : " from " + replay.from_stage());
}

std::string JobLines(const v1::Job& job) {
  const v1::Brief& brief = job.spec().brief();
  return Line("job", job.id()) +
         Line("state", EnumInWords(job.state()) + (job.stage().empty() ? "" : " at " + job.stage())) +
         Line("asked for", PrintableLine(brief.text())) + Line("seed", std::to_string(brief.seed())) +
         Line("created", LocalTimeText(job.create_time())) + Line("replay of", ReplayText(job)) +
         Line("ended", job.has_end_time() ? LocalTimeText(job.end_time()) : "") + Line("error", Printable(job.error()));
}

std::string JobText(const v1::Job& job, ArtifactShelf& shelf) {
  const std::string text = JobLines(job);
  if (job.artifacts().empty()) return text + "\nNo artifacts yet.\n";
  Columns table({"stage", "id", ">bytes", "what"});
  for (const v1::ArtifactRef& ref : job.artifacts()) {
    const absl::StatusOr<v1::Artifact> artifact = shelf.GetArtifact(ref.id());
    table.Add({StageOf(ref.kind()), ref.id().substr(0, 12), fmt::format("{}", ref.size_bytes()),
               artifact.ok() ? orchestrator::Summarize(*artifact) : std::string(artifact.status().message())});
  }
  return text + Heading(fmt::format("ARTIFACTS, {}", job.artifacts_size())) + table.Text(job.artifacts_size()) + "\n" +
         Line("more", fmt::format("flair inspect {}/STAGE", job.id()));
}

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
  if (producer.program().empty()) text = "producer unknown";
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
  return JsonText(json, 1) + "\n";
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
