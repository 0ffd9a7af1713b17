// SPDX-License-Identifier: GPL-3.0-or-later
// What a traced view costs. CPU columns are of the whole process, threads included.
#include <benchmark/benchmark.h>

#include <cstdlib>

#include "renderer_worker/drawing/testing/read_drawing.h"
#include "renderer_worker/furniture/procedural_furniture.h"
#include "renderer_worker/scene/room_shape.h"
#include "renderer_worker/tracing/trace_view.h"

namespace flair::renderer {
namespace {

Scene SceneOf(const v1::SolvedLayout& layout) {
  absl::StatusOr<Scene> scene = BuildScene(layout, ProceduralFurniture());
  if (!scene.ok()) std::abort();
  return *std::move(scene);
}

// Shell, furniture and cameras.
void BuildsAScene(benchmark::State& state) {
  const v1::SolvedLayout layout = ReadSample("l_shaped_studio");
  for (auto _ : state) benchmark::DoNotOptimize(SceneOf(layout));
}
BENCHMARK(BuildsAScene)->Unit(benchmark::kMillisecond);

// A preview as `flair render` makes it, scene and trees included: arguments are paths per pixel and threads.
void Previews(benchmark::State& state, bool birdseye) {
  const v1::SolvedLayout layout = ReadSample("l_shaped_studio");
  TraceOptions options;
  options.sample_count = static_cast<int>(state.range(0));
  options.thread_count = static_cast<int>(state.range(1));
  for (auto _ : state) {
    const Scene scene = SceneOf(layout);
    const auto view = TraceView(scene, birdseye ? scene.birdseye : scene.perspective, options);
    if (!view.ok()) std::abort();
    benchmark::DoNotOptimize(ToneMapped(*view));
  }
}
BENCHMARK_CAPTURE(Previews, birdseye, true)
    ->Args({16, 1})
    ->Args({16, 2})
    ->Args({64, 2})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(Previews, perspective, false)
    ->Args({16, 1})
    ->Args({16, 2})
    ->Args({64, 2})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

// Rays in every direction from the middle of the room: what bounced light costs.
void RaysInEveryDirection(benchmark::State& state) {
  const v1::SolvedLayout layout = ReadSample("l_shaped_studio");
  const Scene scene = SceneOf(layout);
  const Vec3 eye = scene.perspective.target;
  const auto world = World::Make(scene, CutAwayFor(*ShapeOf(layout.graph().room()), {eye.x, eye.y, 1.2F}));
  if (!world.ok()) std::abort();
  const SampleSeeds seeds(1);
  const PixelSamples random(seeds, 0, 0, 1 << 16);
  std::vector<Vec3> directions;
  for (int i = 0; i < 1 << 16; ++i) {
    const Vec3 up{0, 0, (i & 1) == 0 ? 1.0F : -1.0F};
    directions.push_back(CosineDirection(up, random.At(i, Purpose::kBounce)));
  }
  for (auto _ : state) {
    for (const Vec3& direction : directions) {
      benchmark::DoNotOptimize((*world)->Feel({eye.x, eye.y, 1.2F}, direction));
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(directions.size()));
}
BENCHMARK(RaysInEveryDirection)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace flair::renderer
