// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "cli/bench/bench.h"
#include "fmt/format.h"
#include "renderer_worker/furniture/procedural_furniture.h"
#include "renderer_worker/service/handlers.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

constexpr int64_t kAnyAnswer = int64_t{1} << 40;
constexpr char kScene[] = "GLB";

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

std::vector<std::string> RenderKinds() {
  std::vector<std::string> kinds;
  for (const Picture& picture : kPictures) kinds.emplace_back(picture.name);
  kinds.emplace_back(kScene);
  return kinds;
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
  v1::ExportSceneRequest scene;
  *scene.mutable_solved_layout() = layout;
  scene.set_format(v1::SCENE_FORMAT_GLB);
  ASSIGN_OR_RETURN(record[kScene], Measure(bench.repeat_count, [&]() -> absl::StatusOr<size_t> {
                     ASSIGN_OR_RETURN(const auto response, export_scene.Handle(scene, call));
                     return response.scene().size();
                   }));
  return record;
}

std::string RenderTable(const std::vector<Record>& rooms) {
  std::string text =
      fmt::format("{:<12}{:>14}{:>14}{:>14}{:>12}  {}\n", "CPU", "median ms", "p95 ms", "most ms", "KiB", "slowest");
  for (const std::string& kind : RenderKinds()) {
    const std::string time = fmt::format("/{}/cpu_s", kind);
    const std::vector<double> cpu_ms = NumbersAt(rooms, time, 1e3);
    if (cpu_ms.empty()) continue;
    const auto slowest =
        std::ranges::max_element(rooms, {}, [&time](const Record& room) { return NumberAt(room, time).value_or(-1); });
    text += fmt::format("{:<12}{:>14.1f}{:>14.1f}{:>14.1f}{:>12.0f}  {}\n", kind, Quantile(cpu_ms, 0.5),
                        Quantile(cpu_ms, 0.95), Quantile(cpu_ms, 1),
                        Quantile(NumbersAt(rooms, fmt::format("/{}/bytes", kind), 1.0 / 1024), 0.5),
                        (*slowest)["room"].get<std::string>());
  }
  return text;
}

std::string RenderJson(const std::vector<Record>& rooms, const RenderBench& bench) {
  return RecordText({{"repeat_count", bench.repeat_count},
                     {"view_size_px", bench.view_size_px},
                     {"sample_count", bench.sample_count},
                     {"thread_count", bench.thread_count},
                     {"rooms", rooms}});
}

}  // namespace flair::cli
