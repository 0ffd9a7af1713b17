// SPDX-License-Identifier: GPL-3.0-or-later
// The stages that make and draw the layout: translation, solve, render.
#include "orchestrator/pipeline/lent_request.h"
#include "orchestrator/pipeline/model_budget.h"
#include "orchestrator/pipeline/stage.h"
#include "worker_runtime/files/files.h"

namespace flair::orchestrator {
namespace {

absl::StatusOr<v1::Artifact> Draw(const StageRun& run, std::string_view stage, const v1::RenderOptions& options) {
  const v1::Artifact& layout = Input(run, v1::ARTIFACT_KIND_SOLVED_LAYOUT);
  LentRequest<v1::RenderRequest> request;
  request->set_request_id(RequestId(run, stage));
  request.Lend(&v1::RenderRequest::unsafe_arena_set_allocated_solved_layout, layout.solved_layout());
  *request->mutable_options() = options;
  // Not the job's own id: the same layout must give the same picture, whoever asks for it. The layout's id leads to it.
  request->set_job_id(layout.id());
  // The ids that lead from the layout to its brief cover both.
  request->set_brief_text(run.spec.brief().text());
  request->set_brief_seed(run.spec.brief().seed());
  auto response = run.clients.Render(*request, run.call);
  if (!response.ok()) return response.status();
  v1::Artifact artifact;
  *artifact.mutable_preview() = std::move(*response->mutable_preview());
  *artifact.mutable_producer() = response->producer();
  return artifact;
}

constexpr const char* kViewNames[] = {"view_1", "view_2", "view_3", "view_4"};

// The functions of a stage have no memory; so each view has functions of its own.
template <int kNumber>
Stage MakeViewStage() {
  Stage stage;
  stage.name = kViewNames[kNumber];
  stage.output = v1::ARTIFACT_KIND_PREVIEW;
  stage.inputs = {v1::ARTIFACT_KIND_SOLVED_LAYOUT};
  stage.wanted = [](const v1::JobSpec& spec) { return kNumber < spec.further_views_size(); };
  stage.asked = [](const v1::JobSpec& spec) {
    return kNumber < spec.further_views_size() ? runtime::CanonicalBytes(spec.further_views(kNumber)) : "";
  };
  stage.options = nullptr;
  stage.run = [](const StageRun& run) { return Draw(run, kViewNames[kNumber], run.spec.further_views(kNumber)); };
  return stage;
}

}  // namespace

// The catalogue decides what can be translated to, so it counts as an option: another optimizer, another graph.
absl::StatusOr<StageOptions> TranslationOptions(const StageRun& run) {
  absl::StatusOr<std::shared_ptr<const SharedCatalog>> catalog = run.catalogs.Get(run.clients, run.call);
  if (!catalog.ok()) return catalog.status();
  std::string bytes = (*catalog)->digest + runtime::CanonicalBytes(DecidingOptions(run.spec.model_options()));
  return StageOptions{std::move(bytes), *std::move(catalog)};
}

absl::StatusOr<v1::Artifact> RunTranslation(const StageRun& run) {
  using Request = v1::TranslateRequest;
  LentRequest<Request> request;
  request.Lend(&Request::unsafe_arena_set_allocated_catalog, run.catalog->catalog);
  *request->mutable_model_options() = OptionsLeft(run.spec.model_options(), run.model_usage);
  request->set_request_id(RequestId(run, "translation"));
  request.Lend(&Request::unsafe_arena_set_allocated_room, Input(run, v1::ARTIFACT_KIND_ROOM).room());
  request.Lend(&Request::unsafe_arena_set_allocated_zone_plan, Input(run, v1::ARTIFACT_KIND_ZONE_PLAN).zone_plan());
  request.Lend(&Request::unsafe_arena_set_allocated_object_list,
               Input(run, v1::ARTIFACT_KIND_OBJECT_LIST).object_list());
  request.Lend(&Request::unsafe_arena_set_allocated_style_sheet,
               Input(run, v1::ARTIFACT_KIND_STYLE_SHEET).style_sheet());
  request.Lend(&Request::unsafe_arena_set_allocated_constraint_list,
               Input(run, v1::ARTIFACT_KIND_CONSTRAINT_LIST).constraint_list());
  auto response = run.clients.Translate(*request, run.call);
  if (!response.ok()) return response.status();
  v1::Artifact artifact;
  *artifact.mutable_layout_graph() = std::move(*response->mutable_layout_graph());
  *artifact.mutable_producer() = response->producer();
  artifact.mutable_model_calls()->Swap(response->mutable_model_calls());
  return artifact;
}

// With the seed that is used; without the number of threads, which changes no result.
std::string AskedOfSolver(const v1::JobSpec& spec) {
  v1::SolveOptions options = spec.solve_options();
  options.clear_thread_count();
  if (!options.has_seed()) options.set_seed(spec.brief().seed());
  return runtime::CanonicalBytes(options);
}

absl::StatusOr<v1::Artifact> RunSolve(const StageRun& run) {
  LentRequest<v1::SolveRequest> request;
  request->set_request_id(RequestId(run, "solve"));
  request.Lend(&v1::SolveRequest::unsafe_arena_set_allocated_layout_graph,
               Input(run, v1::ARTIFACT_KIND_LAYOUT_GRAPH).layout_graph());
  request->mutable_options()->ParseFromArray(run.options.data(), static_cast<int>(run.options.size()));
  if (run.spec.solve_options().has_thread_count()) {
    request->mutable_options()->set_thread_count(run.spec.solve_options().thread_count());
  }
  auto response = run.clients.Solve(*request, run.call);
  if (!response.ok()) return response.status();
  v1::Artifact artifact;
  *artifact.mutable_solved_layout() = std::move(*response->mutable_solved_layout());
  *artifact.mutable_producer() = response->producer();
  return artifact;
}

std::string AskedOfRenderer(const v1::JobSpec& spec) { return runtime::CanonicalBytes(spec.render_options()); }

absl::StatusOr<v1::Artifact> RunRender(const StageRun& run) { return Draw(run, "render", run.spec.render_options()); }

Stage FurtherViewStage(int number) {
  static_assert(kFurtherViewLimit == 4);
  constexpr Stage (*stages[])() = {MakeViewStage<0>, MakeViewStage<1>, MakeViewStage<2>, MakeViewStage<3>};
  return stages[number]();
}

}  // namespace flair::orchestrator
