// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "cli/bench/bench.h"
#include "fmt/format.h"
#include "optimizer_worker/resolve/resolve_layout.h"
#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "optimizer_worker/stages/stage.h"
#include "renderer_worker/furniture/procedural_furniture.h"
#include "renderer_worker/service/handlers.h"
#include "room/geometry/pose.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

int Held(const v1::SolvedLayout& layout) {
  return static_cast<int>(std::ranges::count_if(
      layout.edge_outcomes(), [](const auto& e) { return e.status() == v1::OUTCOME_STATUS_SATISFIED; }));
}

const v1::Placement* PlacementOf(const v1::SolvedLayout& layout, const std::string& id) {
  for (const v1::Placement& placement : layout.placements()) {
    if (placement.object_id() == id) return &placement;
  }
  return nullptr;
}

// Half a metre towards the middle of the room, where nobody is pushed through a wall.
std::string MoveLine(const v1::SolvedLayout& layout, const v1::Placement& at, double turn_deg) {
  double x = 0, y = 0;
  const auto& vertices = layout.graph().room().floor().vertices();
  for (const v1::Point2& p : vertices) {
    x += p.x_m() / vertices.size();
    y += p.y_m() / vertices.size();
  }
  const double far = std::max(1e-9, std::hypot(x - at.x_m(), y - at.y_m())),
               step = turn_deg == 0 ? std::min(0.5, far) : 0;
  return fmt::format("move {} {} {} {}", at.object_id(), at.x_m() + step / far * (x - at.x_m()),
                     at.y_m() + step / far * (y - at.y_m()), at.theta_rad() * 180 / kPi + turn_deg);
}

std::vector<std::string> EditsOf(const v1::SolvedLayout& layout, int per_kind) {
  std::vector<std::string> lines;
  const auto& objects = layout.graph().object_list().objects();
  const int step = std::max(1, objects.size() / per_kind);
  for (int i = 0; i < objects.size(); i += step) {
    const v1::Object& object = objects[i];
    const v1::Placement* at = PlacementOf(layout, object.id());
    if (at == nullptr) continue;
    lines.push_back(MoveLine(layout, *at, 0));
    lines.push_back(fmt::format("resize {} {}x{}", object.id(), 1.2 * object.width_m(), 1.2 * object.depth_m()));
    lines.push_back(fmt::format("pin {}", object.id()));
    lines.push_back(fmt::format("remove {}", object.id()));
    if (object.kind() != v1::OBJECT_KIND_FLOOR || object.walk_over()) continue;
    lines.push_back(MoveLine(layout, *at, 90));
    lines.push_back(fmt::format("add extra_piece {}x{}x{} near {}", std::min(0.5, object.width_m()),
                                std::min(0.5, object.depth_m()), object.height_m(), object.id()));
  }
  const int stride = std::max(1, layout.graph().edges_size() / per_kind);
  for (int e = 0; e < layout.graph().edges_size(); e += stride) {
    lines.push_back(fmt::format("weight {} 5", layout.graph().edges(e).id()));
    lines.push_back(fmt::format("drop {}", layout.graph().edges(e).id()));
  }
  return lines;
}

constexpr int64_t kAnyAnswer = int64_t{1} << 40;

struct Picture {
  const char* name;
  v1::PreviewView view;
  v1::PreviewFormat format;
};
constexpr Picture kPictures[] = {{"plan PNG", v1::PREVIEW_VIEW_PLAN, v1::PREVIEW_FORMAT_PNG},
                                 {"plan SVG", v1::PREVIEW_VIEW_PLAN, v1::PREVIEW_FORMAT_SVG},
                                 {"plan PDF", v1::PREVIEW_VIEW_PLAN, v1::PREVIEW_FORMAT_PDF},
                                 {"bird's-eye", v1::PREVIEW_VIEW_BIRDSEYE, v1::PREVIEW_FORMAT_PNG}};

// The least CPU of the repeats, and the size of what was made.
template <typename Make>
absl::StatusOr<Record> Measure(int repeat_count, const Make& make) {
  std::vector<double> cpu_s;
  size_t bytes = 0;
  for (int i = 0; i < repeat_count; ++i) {
    const double start_s = ProcessCpu_s();
    ASSIGN_OR_RETURN(bytes, make());
    cpu_s.push_back(ProcessCpu_s() - start_s);
  }
  return Record{{"cpu_s", Quantile(cpu_s, 0)}, {"bytes", bytes}};
}

}  // namespace

absl::StatusOr<std::vector<Record>> MeasureResolves(const BenchProblem& problem, const v1::SolveOptions& options,
                                                    int per_kind) {
  const optimizer::NloptSolver solver;
  ASSIGN_OR_RETURN(const optimizer::SolveResult start, optimizer::SolveLayout(problem.graph, options, solver));
  std::vector<Record> edits;
  for (const std::string& line : EditsOf(start.layout, per_kind)) {
    ASSIGN_OR_RETURN(v1::LayoutEdit edit, optimizer::EditFromText(line, start.layout));
    google::protobuf::RepeatedPtrField<v1::LayoutEdit> one;
    *one.Add() = std::move(edit);
    const double began = ProcessCpu_s();
    const absl::StatusOr<optimizer::ResolveResult> result =
        optimizer::ResolveLayout(start.layout, one, options, solver);
    const double cpu_s = ProcessCpu_s() - began;
    // An object grown or added beyond what validation lets through is no measure of the solver.
    if (!result.ok()) continue;
    edits.push_back(Record{{"room", problem.name},
                           {"edit", line},
                           {"cpu_s", cpu_s},
                           {"moved", result->moved_ids.size()},
                           {"held_before", Held(start.layout)},
                           {"held_after", Held(result->layout)},
                           {"deepest_overlap_m", result->layout.metrics().deepest_overlap_m()}});
  }
  return edits;
}

absl::StatusOr<Record> MeasureRestarts(const BenchProblem& problem, v1::SolveOptions options, int count) {
  options.set_thread_count(1);
  const optimizer::NloptSolver solver;
  ASSIGN_OR_RETURN(const optimizer::SolveInput input,
                   optimizer::MakeSolveInput(problem.graph, options, solver, nullptr));
  const optimizer::StageSpec stage = optimizer::MakeStage(input.scene, optimizer::StageKind::kPrimary);
  if (stage.objects.empty()) return absl::NotFoundError("the room has no primary objects");
  Record measure{{"name", problem.name}, {"scores", Record::array()}, {"cpu_s", Record::array()}};
  for (int k = 0; k < count; ++k) {
    const double started = ThreadCpu_s();
    ASSIGN_OR_RETURN(const std::vector<optimizer::RestartResult> results,
                     optimizer::RunRestarts(input, stage, optimizer::PartialLayout(input.scene), k, 1));
    measure["cpu_s"].push_back(ThreadCpu_s() - started);
    measure["scores"].push_back(results.front().score);
  }
  return measure;
}

absl::StatusOr<Record> MeasureRenders(const std::string& room, const v1::SolvedLayout& layout, const RenderBench& bench,
                                      renderer::ImageWriter& writer) {
  // Meshes are kept while somebody holds them; every room starts with none, as a command does.
  const renderer::ProceduralFurniture furniture;
  const renderer::RenderHandler draw(writer, furniture,
                                     {.thread_count = bench.thread_count, .answer_bytes = kAnyAnswer});
  const renderer::ExportSceneHandler export_scene(furniture, "", kAnyAnswer);
  runtime::CallContext call;
  Record record{{"room", room}, {"object_count", layout.placements_size()}};
  for (const Picture& picture : kPictures) {
    const bool is_view = picture.view != v1::PREVIEW_VIEW_PLAN;
    if (is_view && !bench.views) continue;
    v1::RenderRequest request;
    *request.mutable_solved_layout() = layout;
    request.mutable_options()->set_view(picture.view);
    request.mutable_options()->set_format(picture.format);
    if (is_view) {
      request.mutable_options()->set_size_px(bench.view_size_px);
      request.mutable_options()->set_sample_count(bench.sample_count);
    }
    ASSIGN_OR_RETURN(record[picture.name], Measure(bench.repeat_count, [&]() -> absl::StatusOr<size_t> {
                       ASSIGN_OR_RETURN(const auto response, draw.Handle(request, call));
                       return response.preview().image().size();
                     }));
  }
  v1::DrawPlanPartsRequest parts;
  *parts.mutable_solved_layout() = layout;
  ASSIGN_OR_RETURN(record["plan parts"], Measure(bench.repeat_count, [&]() -> absl::StatusOr<size_t> {
                     ASSIGN_OR_RETURN(const auto response, renderer::PlanPartsHandler(kAnyAnswer).Handle(parts, call));
                     return response.ByteSizeLong();
                   }));
  v1::ExportSceneRequest scene;
  scene.mutable_solved_layout()->Swap(parts.mutable_solved_layout());
  scene.set_format(v1::SCENE_FORMAT_GLB);
  ASSIGN_OR_RETURN(record["GLB"], Measure(bench.repeat_count, [&]() -> absl::StatusOr<size_t> {
                     ASSIGN_OR_RETURN(const auto response, export_scene.Handle(scene, call));
                     return response.scene().size();
                   }));
  return record;
}

}  // namespace flair::cli
