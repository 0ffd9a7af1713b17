// SPDX-License-Identifier: GPL-3.0-or-later
// The stages in order, and how each asks its worker.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "absl/strings/strip.h"
#include "orchestrator/pipeline/stage.h"
#include "orchestrator/store/artifact_id.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

// The input of that kind; it is there because the stage's table entry says so.
const v1::Artifact& Input(const StageRun& run, v1::ArtifactKind kind) {
  const auto found = std::ranges::find(run.inputs, kind, [](const v1::Artifact* input) { return KindOf(*input); });
  return found == run.inputs.end() ? v1::Artifact::default_instance() : **found;
}

// A stage's request with what it has a field for of the stage's inputs, and with what is left of the job's budget.
template <typename Request>
Request RequestOf(const StageRun& run) {
  Request request;
  // The same whenever the stage is run again for the same job.
  request.set_request_id(fmt::format("{}/{}", run.job_id, run.stage));
  static const google::protobuf::OneofDescriptor* const kContent =
      v1::Artifact::descriptor()->FindOneofByName("content");
  for (const v1::Artifact* input : run.inputs) {
    const google::protobuf::Reflection& of_artifact = *input->GetReflection();
    const google::protobuf::FieldDescriptor* content = of_artifact.GetOneofFieldDescriptor(*input, kContent);
    if (content == nullptr) continue;
    // What is to be cleaned, and what has been completed, is a list of constraints as well.
    const std::string name(absl::StripPrefix(absl::StripPrefix(content->name(), "raw_"), "completed_"));
    const google::protobuf::FieldDescriptor* field = Request::descriptor()->FindFieldByName(name);
    if (field == nullptr) continue;
    request.GetReflection()->MutableMessage(&request, field)->CopyFrom(of_artifact.GetMessage(*input, content));
  }
  if constexpr (requires { request.mutable_model_options(); }) {
    *request.mutable_model_options() = OptionsLeft(run.spec.model_options(), run.model_usage);
  }
  return request;
}

// The artifact with `from` of the answer as its content `to`.
template <typename Response, typename Part>
absl::StatusOr<v1::Artifact> ArtifactOf(absl::StatusOr<Response> response, Part* (Response::*from)(),
                                        Part* (v1::Artifact::*to)()) {
  RETURN_IF_ERROR(response.status());
  v1::Artifact artifact;
  *(artifact.*to)() = std::move(*(*response.*from)());
  *artifact.mutable_producer() = response->producer();
  if constexpr (requires { response->mutable_model_calls(); }) {
    artifact.mutable_model_calls()->Swap(response->mutable_model_calls());
  }
  return artifact;
}

template <typename Request, typename Response, typename Part>
absl::StatusOr<v1::Artifact> AskLanguage(const StageRun& run,
                                         absl::StatusOr<Response> (StageClients::*method)(const Request&, StageCall&),
                                         Part* (Response::*from)(), Part* (v1::Artifact::*to)()) {
  return ArtifactOf((run.clients.*method)(RequestOf<Request>(run), run.call), from, to);
}

// A stage's function: asks the language worker by `kMethod`.
template <auto kMethod, auto kFrom, auto kTo>
absl::StatusOr<v1::Artifact> RunLanguage(const StageRun& run) {
  return AskLanguage(run, kMethod, kFrom, kTo);
}

// An artifact of our own.
v1::Artifact OwnArtifact(const StageRun& run, const char* method) {
  v1::Artifact artifact;
  artifact.mutable_producer()->set_program("flair-orchestrator");
  artifact.mutable_producer()->set_method(method);
  artifact.mutable_producer()->set_version("1");
  artifact.mutable_producer()->set_build(run.build);
  return artifact;
}

absl::StatusOr<v1::Artifact> RunBrief(const StageRun& run) {
  v1::Artifact artifact = OwnArtifact(run, "request");
  *artifact.mutable_brief() = BriefOf(run.spec);
  return artifact;
}

// The part of the options that decides results: all but the budget.
std::string AskedOfModels(const v1::JobSpec& spec) {
  v1::ModelOptions options = spec.model_options();
  options.clear_budget();
  return runtime::CanonicalBytes(options);
}

std::string AskedOfCompletion(const v1::JobSpec& spec) { return spec.no_completion() ? "none" : AskedOfModels(spec); }

// Where nobody completes, the list goes on as it is, and a remark says so.
absl::StatusOr<v1::Artifact> RunCompletion(const StageRun& run) {
  std::string why = "The user wants the constraints as they were written.";
  if (!run.spec.no_completion()) {
    absl::StatusOr<v1::Artifact> completed =
        AskLanguage(run, &StageClients::CompleteConstraints, &v1::CompleteConstraintsResponse::mutable_constraint_list,
                    &v1::Artifact::mutable_completed_constraint_list);
    if (!absl::IsUnimplemented(completed.status())) return completed;
    why = "The language worker completes no constraints: what everybody knows of the use of furniture was not added.";
  }
  v1::Artifact artifact = OwnArtifact(run, "completion");
  v1::ConstraintList& list = *artifact.mutable_completed_constraint_list();
  list = Input(run, v1::ARTIFACT_KIND_CONSTRAINT_LIST).constraint_list();
  v1::Diagnostic& remark = *list.add_diagnostics();
  remark.set_severity(v1::SEVERITY_NOTE);
  remark.set_code("not_completed");
  remark.set_message(why);
  return artifact;
}

// The catalogue decides what can be translated to, so it counts as an option: another optimizer, another graph.
absl::StatusOr<StageOptions> TranslationOptions(const StageRun& run) {
  ASSIGN_OR_RETURN(std::shared_ptr<const SharedCatalog> catalog, run.catalogs.Get(run.clients, run.call));
  std::string bytes = catalog->digest + AskedOfModels(run.spec);
  return StageOptions{std::move(bytes), std::move(catalog)};
}

absl::StatusOr<v1::Artifact> RunTranslation(const StageRun& run) {
  auto request = RequestOf<v1::TranslateRequest>(run);
  *request.mutable_catalog() = run.catalog->catalog;
  return ArtifactOf(run.clients.Translate(request, run.call), &v1::TranslateResponse::mutable_layout_graph,
                    &v1::Artifact::mutable_layout_graph);
}

// With the seed that is used; without the number of threads, which changes no result.
std::string AskedOfSolver(const v1::JobSpec& spec) {
  v1::SolveOptions options = spec.solve_options();
  options.clear_thread_count();
  if (!options.has_seed()) options.set_seed(spec.brief().seed());
  return runtime::CanonicalBytes(options);
}

absl::StatusOr<v1::Artifact> RunSolve(const StageRun& run) {
  auto request = RequestOf<v1::SolveRequest>(run);
  request.mutable_options()->ParseFromArray(run.options.data(), static_cast<int>(run.options.size()));
  if (run.spec.solve_options().has_thread_count()) {
    request.mutable_options()->set_thread_count(run.spec.solve_options().thread_count());
  }
  return ArtifactOf(run.clients.Solve(request, run.call), &v1::SolveResponse::mutable_solved_layout,
                    &v1::Artifact::mutable_solved_layout);
}

absl::StatusOr<v1::Artifact> Draw(const StageRun& run, const v1::RenderOptions& options) {
  auto request = RequestOf<v1::RenderRequest>(run);
  *request.mutable_options() = options;
  // Not the job's own id: the same layout must give the same picture, whoever asks for it. The layout's id leads to it.
  request.set_job_id(Input(run, v1::ARTIFACT_KIND_SOLVED_LAYOUT).id());
  // The ids that lead from the layout to its brief cover both.
  request.set_brief_text(run.spec.brief().text());
  request.set_brief_seed(run.spec.brief().seed());
  return ArtifactOf(run.clients.Render(request, run.call), &v1::RenderResponse::mutable_preview,
                    &v1::Artifact::mutable_preview);
}

std::string AskedOfRenderer(const v1::JobSpec& spec) { return runtime::CanonicalBytes(spec.render_options()); }

absl::StatusOr<v1::Artifact> RunRender(const StageRun& run) { return Draw(run, run.spec.render_options()); }

constexpr const char* kViewNames[kFurtherViewLimit] = {"view_1", "view_2", "view_3", "view_4"};

// A stage that draws a further view; `kNumber` counts from 0. The functions of a stage have no memory; so each view has
// functions of its own.
template <int kNumber>
Stage FurtherViewStage() {
  Stage stage;
  stage.name = kViewNames[kNumber];
  stage.output = v1::ARTIFACT_KIND_PREVIEW;
  stage.inputs = {v1::ARTIFACT_KIND_SOLVED_LAYOUT};
  stage.wanted = [](const v1::JobSpec& spec) { return kNumber < spec.further_views_size(); };
  stage.asked = [](const v1::JobSpec& spec) {
    return kNumber < spec.further_views_size() ? runtime::CanonicalBytes(spec.further_views(kNumber)) : "";
  };
  stage.options = nullptr;
  stage.run = [](const StageRun& run) { return Draw(run, run.spec.further_views(kNumber)); };
  return stage;
}

// What the optimizer finds in its layout, looking at it as at anybody's; what it said when it solved, when that is all
// it can tell.
absl::StatusOr<v1::EvaluateResponse> Evaluate(const StageRun& run, const v1::SolvedLayout& layout) {
  auto request = RequestOf<v1::EvaluateRequest>(run);
  *request.mutable_layout_graph() = layout.graph();
  *request.mutable_placements() = layout.placements();
  *request.mutable_options() = run.spec.solve_options();
  absl::StatusOr<v1::EvaluateResponse> response = run.clients.Evaluate(request, run.call);
  if (response.ok() && response->edge_outcomes_size() != layout.graph().edges_size()) {
    const absl::Status bad = Internal("stage \"report\": the optimizer's answer has {} outcomes of {} edges",
                                      response->edge_outcomes_size(), layout.graph().edges_size());
    run.call.ReportBadAnswer(bad);
    return bad;
  }
  if (!absl::IsUnimplemented(response.status())) return response;
  v1::EvaluateResponse said;
  *said.mutable_edge_outcomes() = layout.edge_outcomes();
  if (layout.has_metrics()) *said.mutable_metrics() = layout.metrics();
  return said;
}

// Counts outcomes of edges, and sentences without an edge.
v1::ConstraintSummary CountOutcomes(const v1::SolvedLayout& layout, const v1::EvaluateResponse& evaluation) {
  v1::ConstraintSummary summary;
  for (const v1::EdgeOutcome& outcome : evaluation.edge_outcomes()) {
    switch (outcome.status()) {
      case v1::OUTCOME_STATUS_SATISFIED:
        summary.set_satisfied_count(summary.satisfied_count() + 1);
        break;
      case v1::OUTCOME_STATUS_VIOLATED:
        summary.set_violated_count(summary.violated_count() + 1);
        break;
      default:
        summary.set_dropped_count(summary.dropped_count() + 1);
    }
  }
  for (const v1::Sentence& sentence : layout.graph().constraint_list().sentences()) {
    const bool translated = std::ranges::any_of(
        layout.graph().edges(), [&](const v1::ConstraintEdge& edge) { return edge.sentence_id() == sentence.id(); });
    if (!translated) summary.set_untranslated_count(summary.untranslated_count() + 1);
  }
  return summary;
}

// A report belongs to one job and is never used for another.
absl::StatusOr<StageOptions> ReportOptions(const StageRun& run) { return StageOptions{run.job_id, nullptr}; }

absl::StatusOr<v1::Artifact> RunReport(const StageRun& run) {
  const v1::SolvedLayout& layout = Input(run, v1::ARTIFACT_KIND_SOLVED_LAYOUT).solved_layout();
  ASSIGN_OR_RETURN(const v1::EvaluateResponse evaluation, Evaluate(run, layout));
  v1::Artifact artifact = OwnArtifact(run, "report");
  v1::Report& report = *artifact.mutable_report();
  report.set_job_id(run.job_id);
  if (evaluation.has_metrics()) *report.mutable_metrics() = evaluation.metrics();
  *report.mutable_constraints() = CountOutcomes(layout, evaluation);
  report.mutable_stage_timings()->Assign(run.timings.begin(), run.timings.end());
  if (run.model_usage.call_count() > 0) *report.mutable_model_usage() = run.model_usage;
  const v1::LayoutGraph& graph = layout.graph();
  for (const auto* diagnostics :
       {&graph.room().diagnostics(), &graph.zone_plan().diagnostics(), &graph.object_list().diagnostics(),
        &graph.style_sheet().diagnostics(),
        &Input(run, v1::ARTIFACT_KIND_RAW_CONSTRAINT_LIST).raw_constraint_list().diagnostics(),
        &graph.constraint_list().diagnostics(), &graph.diagnostics(), &layout.diagnostics()}) {
    report.mutable_diagnostics()->MergeFrom(*diagnostics);
  }
  return artifact;
}

}  // namespace

std::string AskedBrief(const v1::JobSpec& spec) { return runtime::CanonicalBytes(spec.brief()); }

std::span<const Stage> Stages() {
  using namespace v1;  // Their kinds and messages in one table.
  using Clients = StageClients;
  static const std::vector<Stage> stages = {
      {"brief", ARTIFACT_KIND_BRIEF, {}, AskedBrief, nullptr, RunBrief},
      {"room",
       ARTIFACT_KIND_ROOM,
       {ARTIFACT_KIND_BRIEF},
       AskedOfModels,
       nullptr,
       RunLanguage<&Clients::DescribeRoom, &DescribeRoomResponse::mutable_room, &Artifact::mutable_room>},
      {"zones",
       ARTIFACT_KIND_ZONE_PLAN,
       {ARTIFACT_KIND_BRIEF, ARTIFACT_KIND_ROOM},
       AskedOfModels,
       nullptr,
       RunLanguage<&Clients::PlanZones, &PlanZonesResponse::mutable_zone_plan, &Artifact::mutable_zone_plan>},
      {"objects",
       ARTIFACT_KIND_OBJECT_LIST,
       {ARTIFACT_KIND_BRIEF, ARTIFACT_KIND_ROOM, ARTIFACT_KIND_ZONE_PLAN},
       AskedOfModels,
       nullptr,
       RunLanguage<&Clients::ListObjects, &ListObjectsResponse::mutable_object_list, &Artifact::mutable_object_list>},
      {"style",
       ARTIFACT_KIND_STYLE_SHEET,
       {ARTIFACT_KIND_BRIEF, ARTIFACT_KIND_ROOM, ARTIFACT_KIND_ZONE_PLAN, ARTIFACT_KIND_OBJECT_LIST},
       AskedOfModels,
       nullptr,
       RunLanguage<&Clients::ChooseStyle, &ChooseStyleResponse::mutable_style_sheet, &Artifact::mutable_style_sheet>},
      {"constraints",
       ARTIFACT_KIND_RAW_CONSTRAINT_LIST,
       {ARTIFACT_KIND_BRIEF, ARTIFACT_KIND_ROOM, ARTIFACT_KIND_ZONE_PLAN, ARTIFACT_KIND_OBJECT_LIST},
       AskedOfModels,
       nullptr,
       RunLanguage<&Clients::ListConstraints, &ListConstraintsResponse::mutable_constraint_list,
                   &Artifact::mutable_raw_constraint_list>},
      {"cleaning",
       ARTIFACT_KIND_CONSTRAINT_LIST,
       {ARTIFACT_KIND_ROOM, ARTIFACT_KIND_OBJECT_LIST, ARTIFACT_KIND_RAW_CONSTRAINT_LIST},
       AskedOfModels,
       nullptr,
       RunLanguage<&Clients::CleanConstraints, &CleanConstraintsResponse::mutable_constraint_list,
                   &Artifact::mutable_constraint_list>},
      {"completion",
       ARTIFACT_KIND_COMPLETED_CONSTRAINT_LIST,
       {ARTIFACT_KIND_BRIEF, ARTIFACT_KIND_ROOM, ARTIFACT_KIND_ZONE_PLAN, ARTIFACT_KIND_OBJECT_LIST,
        ARTIFACT_KIND_CONSTRAINT_LIST},
       AskedOfCompletion,
       nullptr,
       RunCompletion},
      {"translation",
       ARTIFACT_KIND_LAYOUT_GRAPH,
       {ARTIFACT_KIND_ROOM, ARTIFACT_KIND_ZONE_PLAN, ARTIFACT_KIND_OBJECT_LIST, ARTIFACT_KIND_STYLE_SHEET,
        ARTIFACT_KIND_COMPLETED_CONSTRAINT_LIST},
       AskedOfModels,
       TranslationOptions,
       RunTranslation},
      {"solve", ARTIFACT_KIND_SOLVED_LAYOUT, {ARTIFACT_KIND_LAYOUT_GRAPH}, AskedOfSolver, nullptr, RunSolve},
      {"render", ARTIFACT_KIND_PREVIEW, {ARTIFACT_KIND_SOLVED_LAYOUT}, AskedOfRenderer, nullptr, RunRender},
      {"report",
       ARTIFACT_KIND_REPORT,
       {ARTIFACT_KIND_RAW_CONSTRAINT_LIST, ARTIFACT_KIND_SOLVED_LAYOUT, ARTIFACT_KIND_PREVIEW},
       nullptr,
       ReportOptions,
       RunReport},
      FurtherViewStage<0>(),
      FurtherViewStage<1>(),
      FurtherViewStage<2>(),
      FurtherViewStage<3>(),
  };
  return stages;
}

}  // namespace flair::orchestrator
