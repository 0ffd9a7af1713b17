// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing a plan: a room of each sample layout in turn, on one core. Encoding as PNG is measured apart and with it.
#include <benchmark/benchmark.h>

#include <vector>

#include "renderer_worker/drawing/draw_plan.h"
#include "renderer_worker/drawing/testing/read_layout.h"
#include "renderer_worker/images/image_writer.h"

namespace flair::renderer {
namespace {

const std::vector<v1::SolvedLayout>& Rooms() {
  static const auto& rooms = *[] {
    auto* read = new std::vector<v1::SolvedLayout>;
    for (const std::string& name : SampleLayouts()) read->push_back(ReadSample(name));
    return read;
  }();
  return rooms;
}

v1::RenderOptions Options(v1::PreviewFormat format) {
  v1::RenderOptions options;
  options.set_format(format);
  return options;
}

void Pixels1600(benchmark::State& state) {
  size_t room = 0;
  for (auto _ : state) benchmark::DoNotOptimize(DrawPlan(Rooms()[room++ % Rooms().size()], {}));
}
BENCHMARK(Pixels1600)->Unit(benchmark::kMillisecond);

void Png1600(benchmark::State& state) {
  const std::unique_ptr<ImageWriter> writer = MakeImageWriter();
  size_t room = 0;
  for (auto _ : state) {
    const absl::StatusOr<DrawnPlan> drawn = DrawPlan(Rooms()[room++ % Rooms().size()], {});
    benchmark::DoNotOptimize(writer->WritePng(drawn->pixels, {}));
  }
}
BENCHMARK(Png1600)->Unit(benchmark::kMillisecond);

void Document(benchmark::State& state, v1::PreviewFormat format) {
  size_t room = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(DrawPlanDocument(Rooms()[room++ % Rooms().size()], Options(format), {}));
}
BENCHMARK_CAPTURE(Document, svg, v1::PREVIEW_FORMAT_SVG)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Document, pdf, v1::PREVIEW_FORMAT_PDF)->Unit(benchmark::kMillisecond);

void Tile480(benchmark::State& state) {
  size_t room = 0;
  for (auto _ : state) benchmark::DoNotOptimize(DrawPlanTile(Rooms()[room++ % Rooms().size()], 480, 480));
}
BENCHMARK(Tile480)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace flair::renderer
