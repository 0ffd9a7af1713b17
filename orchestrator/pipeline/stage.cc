// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/pipeline/stage.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "orchestrator/store/artifact_id.h"
#include "room/validation/validate.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::orchestrator {
namespace {

// Optimizers of more revisions than this are not at work at once.
constexpr size_t kCatalogsKept = 4;

const Stage& StageAt(int index) { return Stages()[static_cast<size_t>(index)]; }

// At most 80 bytes, not cut inside a character.
std::string Shorten(const std::string& text) {
  if (text.size() <= 80) return text;
  size_t end = 77;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  return text.substr(0, end) + "...";
}

std::string OfRoom(const v1::Room& room) {
  double width = 0;
  double depth = 0;
  for (const v1::Point2& vertex : room.floor().vertices()) {
    width = std::max(width, vertex.x_m());
    depth = std::max(depth, vertex.y_m());
  }
  const auto doors = std::ranges::count_if(
      room.openings(), [](const v1::Opening& opening) { return opening.kind() == v1::OPENING_KIND_DOOR; });
  return fmt::format("{}, {:.4g} m x {:.4g} m: {}, {}, {}", room.room_type().empty() ? "room" : room.room_type(), width,
                     depth, Counted(doors, "door"), Counted(room.openings_size() - doors, "window"),
                     Counted(room.sockets_size(), "socket"));
}

std::string OfZones(const v1::ZonePlan& plan) {
  std::string names;
  for (const v1::Zone& zone : plan.zones()) names += (names.empty() ? "" : ", ") + zone.name();
  return fmt::format("{}: {}", Counted(plan.zones_size(), "zone"), names);
}

std::string OfObjects(const v1::ObjectList& list) {
  int roles[v1::ObjectRole_ARRAYSIZE] = {};
  for (const v1::Object& object : list.objects()) {
    if (v1::ObjectRole_IsValid(object.role())) ++roles[object.role()];
  }
  std::string text =
      fmt::format("{}: {} primary, {} secondary, {} tertiary", Counted(list.objects_size(), "object"),
                  roles[v1::OBJECT_ROLE_PRIMARY], roles[v1::OBJECT_ROLE_SECONDARY], roles[v1::OBJECT_ROLE_TERTIARY]);
  if (list.omissions_size() > 0) text += fmt::format("; {} left out", list.omissions_size());
  return text;
}

std::string OfCleaned(const v1::ConstraintList& list) {
  const std::string sentences = Counted(list.sentences_size(), "sentence");
  if (list.cleaning_steps().empty()) return sentences + ", nothing to clean";
  const std::pair<v1::CleaningAction, std::string_view> actions[] = {
      {v1::CLEANING_ACTION_MERGED, "merged"},
      {v1::CLEANING_ACTION_SPLIT, "split"},
      {v1::CLEANING_ACTION_CONTRADICTION_REMOVED, "contradictory"},
      {v1::CLEANING_ACTION_SIMPLIFIED, "simplified"}};
  std::string done;
  for (const auto& [action, name] : actions) {
    const auto count = std::ranges::count_if(
        list.cleaning_steps(), [action = action](const v1::CleaningStep& step) { return step.action() == action; });
    if (count > 0) done += fmt::format("{}{} {}", done.empty() ? "" : ", ", count, name);
  }
  return fmt::format("{} ({})", sentences, done);
}

std::string OfCompleted(const v1::ConstraintList& list) {
  const auto implied = std::ranges::count_if(
      list.sentences(), [](const v1::Sentence& one) { return one.origin() == v1::SENTENCE_ORIGIN_IMPLIED; });
  return fmt::format("{}, {} of them implied", Counted(list.sentences_size(), "sentence"), implied);
}

std::string OfLayout(const v1::SolvedLayout& layout) {
  const auto held = std::ranges::count_if(layout.edge_outcomes(), [](const v1::EdgeOutcome& outcome) {
    return outcome.status() == v1::OUTCOME_STATUS_SATISFIED;
  });
  return fmt::format("{} placed; {} of {} hold", Counted(layout.placements_size(), "object"), held,
                     Counted(layout.edge_outcomes_size(), "constraint"));
}

std::string OfReport(const v1::Report& report) {
  return fmt::format("OOB {:.3f} %, OOR {:.3f} %; {} held, {} not, {} dropped, {} not understood",
                     report.metrics().oob_percent(), report.metrics().oor_percent(),
                     report.constraints().satisfied_count(), report.constraints().violated_count(),
                     report.constraints().dropped_count(), report.constraints().untranslated_count());
}

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
    return Internal("stage \"{}\": the worker's answer has no {}", stage.name, v1::ArtifactKind_Name(stage.output));
  }
  absl::Status status = Validate(artifact);
  const v1::SolvedLayout& layout = artifact.solved_layout();
  if (status.ok() && layout.placements().empty() && !layout.graph().object_list().objects().empty()) {
    status = absl::InvalidArgumentError("solved_layout.placements: there are none, of objects that there are");
  }
  if (status.ok()) return status;
  const std::string& program = artifact.producer().program();
  return Internal("stage \"{}\": the answer of {} is not valid: {}", stage.name,
                  program.empty() ? "a worker that does not name itself" : program, status.message());
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

const v1::ArtifactRef* GivenLayout(const v1::Job& job) {
  const auto of_kind = [&job](v1::ArtifactKind kind) {
    return std::ranges::find(job.artifacts(), kind, &v1::ArtifactRef::kind);
  };
  const auto layout = of_kind(v1::ARTIFACT_KIND_SOLVED_LAYOUT);
  const bool solved = of_kind(v1::ARTIFACT_KIND_LAYOUT_GRAPH) != job.artifacts().end();
  return solved || layout == job.artifacts().end() ? nullptr : &*layout;
}

int FirstStageOf(const v1::Replay& replay) { return replay.from_stage().empty() ? 0 : StageIndex(replay.from_stage()); }

absl::Status CheckReplay(const v1::JobSpec& spec, const v1::Job& earlier) {
  const v1::Replay& replay = spec.replay();
  const int first = FirstStageOf(replay);
  if (first < 0) {
    return InvalidArgument("spec.replay.from_stage: there is no stage \"{}\"; one of {}",
                           replay.from_stage().substr(0, 80), StageNames());
  }
  if (first == 0) return absl::OkStatus();
  if (AskedBrief(spec) != AskedBrief(earlier.spec())) {
    return InvalidArgument(
        "spec.brief: is not the brief of job {}, whose \"brief\" is taken; give that brief, or run all "
        "stages again with spec.replay.from_stage empty",
        replay.job_id());
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
  return FailedPrecondition(
      "job {} has no artifact of the stage \"{}\" to take; run it again from \"{}\" or an earlier stage",
      replay.job_id(), stage.name, stage.name);
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

std::string Summarize(const v1::Artifact& artifact) {
  switch (artifact.content_case()) {
    case v1::Artifact::kBrief:
      return fmt::format("\"{}\"", Shorten(artifact.brief().text()));
    case v1::Artifact::kRoom:
      return OfRoom(artifact.room());
    case v1::Artifact::kZonePlan:
      return OfZones(artifact.zone_plan());
    case v1::Artifact::kObjectList:
      return OfObjects(artifact.object_list());
    case v1::Artifact::kStyleSheet:
      return artifact.style_sheet().name();
    case v1::Artifact::kRawConstraintList:
      return Counted(artifact.raw_constraint_list().sentences_size(), "sentence");
    case v1::Artifact::kConstraintList:
      return OfCleaned(artifact.constraint_list());
    case v1::Artifact::kCompletedConstraintList:
      return OfCompleted(artifact.completed_constraint_list());
    case v1::Artifact::kLayoutGraph:
      return fmt::format("{} of {}", Counted(artifact.layout_graph().edges_size(), "constraint"),
                         Counted(artifact.layout_graph().constraint_list().sentences_size(), "sentence"));
    case v1::Artifact::kSolvedLayout:
      return OfLayout(artifact.solved_layout());
    case v1::Artifact::kPreview:
      return fmt::format("{} x {} px, {} kB", artifact.preview().width_px(), artifact.preview().height_px(),
                         (artifact.preview().image().size() + 999) / 1000);
    case v1::Artifact::kReport:
      return OfReport(artifact.report());
    case v1::Artifact::CONTENT_NOT_SET:
      break;
  }
  return "";
}

bool IsRepair(const v1::ModelCall& call) { return call.step().ends_with("/repair"); }

std::string SummarizeUsage(const v1::ModelUsage& usage) {
  std::string text = fmt::format("{}{} tokens", usage.estimated() ? "about " : "",
                                 usage.input_token_count() + usage.output_token_count());
  if (usage.cost_usd() > 0) text += fmt::format(", {:.4f} USD", usage.cost_usd());
  return text;
}

std::string SummarizeModels(const v1::Artifact& artifact) {
  if (artifact.model_calls().empty()) return "";
  std::set<std::string> models;
  for (const v1::ModelCall& call : artifact.model_calls()) models.insert(call.model());
  v1::ModelUsage usage;
  AddUsage(artifact, usage);
  const auto repairs = std::ranges::count_if(artifact.model_calls(), IsRepair);
  return fmt::format("{} of {}{}, {}", Counted(artifact.model_calls_size(), "call"), fmt::join(models, ", "),
                     repairs > 0 ? ", " + Counted(repairs, "repair") : "", SummarizeUsage(usage));
}

void AddUsage(const v1::Artifact& artifact, v1::ModelUsage& usage) {
  for (const v1::ModelCall& call : artifact.model_calls()) {
    const v1::ModelUsage& used = call.usage();
    usage.set_call_count(usage.call_count() + used.call_count());
    usage.set_input_token_count(usage.input_token_count() + used.input_token_count());
    usage.set_output_token_count(usage.output_token_count() + used.output_token_count());
    usage.set_cached_input_token_count(usage.cached_input_token_count() + used.cached_input_token_count());
    usage.set_estimated(usage.estimated() || used.estimated());
    usage.set_cost_usd(usage.cost_usd() + used.cost_usd());
  }
}

v1::ModelOptions OptionsLeft(const v1::ModelOptions& job_options, const v1::ModelUsage& spent) {
  v1::ModelOptions options = job_options;
  if (!options.has_budget()) return options;
  v1::ModelBudget& budget = *options.mutable_budget();
  if (budget.has_call_count()) budget.set_call_count(std::max(0, budget.call_count() - spent.call_count()));
  if (budget.has_token_count()) {
    const int64_t tokens = spent.input_token_count() + spent.output_token_count();
    budget.set_token_count(std::max<int64_t>(0, budget.token_count() - tokens));
  }
  if (budget.has_cost_usd()) budget.set_cost_usd(std::max(0.0, budget.cost_usd() - spent.cost_usd()));
  return options;
}

}  // namespace flair::orchestrator
