// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/inspect/inspection.h"

#include "cli/inspect/provenance.h"
#include "cli/output/artifact_text.h"
#include "cli/output/models_text.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "google/protobuf/util/time_util.h"
#include "orchestrator/pipeline/summary.h"
#include "orchestrator/store/artifact_id.h"

namespace flair::cli {
namespace {

std::string IdLine(const ArtifactFile& file) {
  const std::string id = file.edited || file.whole.ok() ? file.artifact.id() : file.stated_id;
  if (!file.whole.ok()) return fmt::format("{} (does NOT match its bytes: corrupt)", id);
  if (!file.edited) return fmt::format("{} (matches its bytes)", id);
  return fmt::format("{} (of its bytes; {})", id,
                     file.stated_id.empty() ? "the file states none" : "changed since it was " + file.stated_id);
}

std::string MakerLines(const v1::Artifact& artifact) {
  const v1::Producer& producer = artifact.producer();
  std::string text;
  if (IsEdited(artifact)) {
    text = fmt::format("{:<11}hand, {}\n", "edited by",
                       producer.version().empty() ? "nobody says who made it before" : producer.version());
  } else if (!producer.program().empty()) {
    text = fmt::format("{:<11}{}, {}, version {}{}\n", "made by", producer.program(), producer.method(),
                       producer.version(), producer.build().empty() ? "" : ", build " + producer.build());
  }
  if (!producer.configuration_digest().empty()) {
    text += fmt::format("{:<11}{}\n", "configured", producer.configuration_digest());
  }
  if (!artifact.options_digest().empty()) text += fmt::format("{:<11}{}\n", "options", artifact.options_digest());
  return text;
}

std::string OriginLines(const v1::Artifact& artifact, ArtifactFinder& finder) {
  if (artifact.made_from_ids().empty()) return "";
  const std::vector<ProvenanceStep> steps = FindProvenance(artifact, finder);
  std::string text;
  for (int i = 0; i < artifact.made_from_ids_size(); ++i) {
    const std::string& id = artifact.made_from_ids(i);
    std::string name = finder.FileBeside(id);
    for (const ProvenanceStep& step : steps) {
      if (name.empty() && step.id == id) name = step.name.empty() ? "not found" : step.name;
    }
    text += fmt::format("{:<11}{}  {}\n", i == 0 ? "made from" : "", id, name);
  }
  return text + fmt::format("{:<11}{}\n", "the way", ProvenanceLine(steps));
}

std::string ProblemLines(const absl::Status& good) {
  if (good.ok()) return "";
  return fmt::format("\nNOT VALID\n{}\n", std::string(good.message()));
}

// The list that a cleaned one was made from.
std::optional<ArtifactFinder::Found> FindRaw(const v1::Artifact& artifact, ArtifactFinder& finder) {
  for (const std::string& id : artifact.made_from_ids()) {
    std::optional<ArtifactFinder::Found> found = finder.Find(id);
    if (found && found->artifact.has_raw_constraint_list()) return found;
  }
  return std::nullopt;
}

}  // namespace

std::string ContentText(const v1::Artifact& artifact, ArtifactFinder& finder, const ContentStyle& style) {
  switch (artifact.content_case()) {
    case v1::Artifact::kBrief:
      return BriefText(artifact.brief(), style);
    case v1::Artifact::kRoom:
      return RoomText(artifact.room(), style);
    case v1::Artifact::kZonePlan:
      return ZonesText(artifact.zone_plan(), style);
    case v1::Artifact::kObjectList:
      return ObjectsText(artifact.object_list(), style);
    case v1::Artifact::kStyleSheet:
      return StyleText(artifact.style_sheet(), style);
    case v1::Artifact::kRawConstraintList:
      return SentencesText(artifact.raw_constraint_list(), style);
    case v1::Artifact::kConstraintList: {
      const std::optional<ArtifactFinder::Found> raw = FindRaw(artifact, finder);
      return CleanedText(artifact.constraint_list(), raw ? &raw->artifact.raw_constraint_list() : nullptr, style);
    }
    case v1::Artifact::kLayoutGraph:
      return GraphText(artifact.layout_graph(), style);
    case v1::Artifact::kSolvedLayout:
      return LayoutText(artifact.solved_layout(), style);
    case v1::Artifact::kPreview:
      return PreviewText(artifact.preview(), style);
    case v1::Artifact::kReport:
      return ReportText(artifact.report(), style);
    case v1::Artifact::CONTENT_NOT_SET:
      break;
  }
  return "";
}

std::string InspectionText(const std::string& name, const ArtifactFile& file, ArtifactFinder& finder,
                           const ContentStyle& style) {
  const v1::Artifact& artifact = file.artifact;
  std::string text = fmt::format("{:<11}{}: {}\n{:<11}{}\n", "what", KindName(orchestrator::KindOf(artifact)),
                                 orchestrator::Summarize(artifact), "id", IdLine(file));
  text += MakerLines(artifact) + OriginLines(artifact, finder);
  if (const std::string models = orchestrator::SummarizeModels(artifact); !models.empty()) {
    text += fmt::format("{:<11}{}\n{}", "model", models, ModelCallLines(artifact));
  }
  text += ProblemLines(file.good);
  const std::string content = ContentText(artifact, finder, style);
  text += (content.starts_with('\n') ? "" : "\n") + content;
  return text +
         fmt::format("\n{:<11}flair inspect {} --provenance | --field PATH | --format json | --format textproto{}\n",
                     "more", name, artifact.model_calls().empty() ? "" : " | --calls");
}

std::string JobText(const v1::Job& job, ArtifactShelf& shelf) {
  using google::protobuf::util::TimeUtil;
  const v1::Brief& brief = job.spec().brief();
  std::string text = fmt::format("{:<11}{}\n{:<11}{}{}\n{:<11}{}\n{:<11}{}\n{:<11}{}\n", "job", job.id(), "state",
                                 ShortName(v1::JobState_Name(job.state()), "JOB_STATE_"),
                                 job.stage().empty() ? "" : " at " + job.stage(), "asked for", brief.text(), "seed",
                                 brief.seed(), "created", TimeUtil::ToString(job.create_time()));
  if (job.has_end_time()) text += fmt::format("{:<11}{}\n", "ended", TimeUtil::ToString(job.end_time()));
  if (!job.error().empty()) text += fmt::format("{:<11}{}\n", "error", job.error());
  if (job.artifacts().empty()) return text + "\nNo artifacts yet.\n";
  Columns table({"stage", "id", ">bytes", "what"});
  for (const v1::ArtifactRef& ref : job.artifacts()) {
    const absl::StatusOr<v1::Artifact> artifact = shelf.GetArtifact(ref.id());
    table.Add({StageOf(ref.kind()), ref.id().substr(0, 12), fmt::format("{}", ref.size_bytes()),
               artifact.ok() ? orchestrator::Summarize(*artifact) : std::string(artifact.status().message())});
  }
  return text + Heading(fmt::format("ARTIFACTS, {}", job.artifacts_size())) + table.Text(job.artifacts_size()) +
         fmt::format("\n{:<11}flair inspect {}/STAGE\n", "more", job.id());
}

}  // namespace flair::cli
