// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/inspect/inspection.h"

#include "cli/inspect/content_text.h"
#include "cli/inspect/provenance.h"
#include "cli/output/artifact_text.h"
#include "cli/output/message_view.h"
#include "cli/output/models_text.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "google/protobuf/util/time_util.h"
#include "orchestrator/pipeline/summary.h"
#include "orchestrator/store/artifact_id.h"

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
              "hand, " + (producer.version().empty() ? "nobody says who made it before" : producer.version()));
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

std::string JobText(const v1::Job& job, ArtifactShelf& shelf) {
  using google::protobuf::util::TimeUtil;
  const v1::Brief& brief = job.spec().brief();
  const std::string text = Line("job", job.id()) +
                           Line("state", EnumInWords(job.state()) + (job.stage().empty() ? "" : " at " + job.stage())) +
                           Line("asked for", brief.text()) + Line("seed", std::to_string(brief.seed())) +
                           Line("created", TimeUtil::ToString(job.create_time())) +
                           Line("ended", job.has_end_time() ? TimeUtil::ToString(job.end_time()) : "") +
                           Line("error", job.error());
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

}  // namespace flair::cli
