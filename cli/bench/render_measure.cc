// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/render_measure.h"

#include <algorithm>
#include <functional>

#include "cli/bench/statistics.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "renderer_worker/furniture/procedural_furniture.h"
#include "renderer_worker/service/handlers.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

constexpr int64_t kAnyAnswer = int64_t{1} << 40;

v1::RenderRequest RequestOf(const v1::SolvedLayout& layout, v1::PreviewView view, v1::PreviewFormat format) {
  v1::RenderRequest request;
  *request.mutable_solved_layout() = layout;
  request.mutable_options()->set_view(view);
  request.mutable_options()->set_format(format);
  return request;
}

// The least CPU of the repeats, and the size of what was made.
absl::Status Measure(const std::function<absl::StatusOr<size_t>()>& make, int repeat_count, double& cpu_s,
                     size_t& bytes) {
  for (int i = 0; i < repeat_count; ++i) {
    const double start_s = ProcessCpu_s();
    const absl::StatusOr<size_t> made = make();
    const double taken_s = ProcessCpu_s() - start_s;
    if (!made.ok()) return made.status();
    cpu_s = i == 0 ? taken_s : std::min(cpu_s, taken_s);
    bytes = *made;
  }
  return absl::OkStatus();
}

std::vector<double> Column(std::span<const RenderMeasure> measures, int kind) {
  std::vector<double> values;
  for (const RenderMeasure& measure : measures) {
    if (measure.cpu_s[kind] >= 0) values.push_back(measure.cpu_s[kind]);
  }
  return values;
}

}  // namespace

absl::StatusOr<RenderMeasure> MeasureRenders(const std::string& room, const v1::SolvedLayout& layout,
                                             const RenderBench& bench, renderer::ImageWriter& writer) {
  // Meshes are kept while somebody holds them; every room starts with none, as a command does.
  const renderer::ProceduralFurniture furniture;
  const renderer::RenderHandler draw(writer, furniture,
                                     {.thread_count = bench.thread_count, .answer_bytes = kAnyAnswer});
  const renderer::ExportSceneHandler export_scene(furniture, "", kAnyAnswer);
  v1::RenderRequest requests[] = {
      RequestOf(layout, v1::PREVIEW_VIEW_PLAN, v1::PREVIEW_FORMAT_PNG),
      RequestOf(layout, v1::PREVIEW_VIEW_PLAN, v1::PREVIEW_FORMAT_SVG),
      RequestOf(layout, v1::PREVIEW_VIEW_PLAN, v1::PREVIEW_FORMAT_PDF),
      RequestOf(layout, v1::PREVIEW_VIEW_BIRDSEYE, v1::PREVIEW_FORMAT_PNG),
  };
  requests[3].mutable_options()->set_size_px(bench.view_size_px);
  requests[3].mutable_options()->set_sample_count(bench.sample_count);
  v1::ExportSceneRequest scene;
  *scene.mutable_solved_layout() = layout;
  scene.set_format(v1::SCENE_FORMAT_GLB);
  runtime::CallContext call;
  RenderMeasure measure{.room = room, .object_count = layout.placements_size()};
  for (int kind = 0; kind < kRenderKindCount; ++kind) {
    if (kind == 3 && !bench.views) {
      measure.cpu_s[kind] = -1;
      continue;
    }
    const auto make = [&]() -> absl::StatusOr<size_t> {
      if (kind < 4) {
        ASSIGN_OR_RETURN(const auto response, draw.Handle(requests[kind], call));
        return response.preview().image().size();
      }
      ASSIGN_OR_RETURN(const auto response, export_scene.Handle(scene, call));
      return response.scene().size();
    };
    RETURN_IF_ERROR(Measure(make, bench.repeat_count, measure.cpu_s[kind], measure.bytes[kind]));
  }
  return measure;
}

std::string RenderTable(std::span<const RenderMeasure> measures) {
  std::string text =
      fmt::format("{:<12}{:>14}{:>14}{:>14}{:>12}  {}\n", "CPU", "median ms", "p95 ms", "most ms", "KiB", "slowest");
  for (int kind = 0; kind < kRenderKindCount; ++kind) {
    const std::vector<double> values = Column(measures, kind);
    if (values.empty()) continue;
    const auto slowest = std::max_element(measures.begin(), measures.end(),
                                          [&](const auto& a, const auto& b) { return a.cpu_s[kind] < b.cpu_s[kind]; });
    std::vector<double> sizes;
    for (const RenderMeasure& measure : measures) sizes.push_back(static_cast<double>(measure.bytes[kind]) / 1024);
    text +=
        fmt::format("{:<12}{:>14.1f}{:>14.1f}{:>14.1f}{:>12.0f}  {}\n", kRenderKinds[kind], 1e3 * Quantile(values, 0.5),
                    1e3 * Quantile(values, 0.95), 1e3 * Quantile(values, 1), Quantile(sizes, 0.5), slowest->room);
  }
  return text;
}

std::string RenderJson(std::span<const RenderMeasure> measures, const RenderBench& bench) {
  nlohmann::ordered_json json = {{"repeat_count", bench.repeat_count},
                                 {"view_size_px", bench.view_size_px},
                                 {"sample_count", bench.sample_count},
                                 {"thread_count", bench.thread_count},
                                 {"rooms", nlohmann::ordered_json::array()}};
  for (const RenderMeasure& measure : measures) {
    nlohmann::ordered_json room = {{"room", measure.room}, {"object_count", measure.object_count}};
    for (int kind = 0; kind < kRenderKindCount; ++kind) {
      if (measure.cpu_s[kind] < 0) continue;
      room[kRenderKinds[kind]] = {{"cpu_s", measure.cpu_s[kind]}, {"bytes", measure.bytes[kind]}};
    }
    json["rooms"].push_back(std::move(room));
  }
  return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace flair::cli
