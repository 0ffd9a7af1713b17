// SPDX-License-Identifier: GPL-3.0-or-later
// Value and gradient of every constraint at the first violated layout of its facts: the expensive case, because
// satisfied costs end early.
#include <benchmark/benchmark.h>

#include <memory>

#include "optimizer_worker/constraints/arguments.h"
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/registry.h"
#include "room/text_format/scene_text.h"

namespace flair::optimizer {
namespace {

// A bound call with the poses it reads.
struct Bound {
  std::shared_ptr<Cost> cost;
  std::vector<Pose<double>> poses;
};

Bound BindExample(const ConstraintFacts& facts, const LayoutExample& example) {
  const absl::StatusOr<SceneText> text = ParseScene(example.scene);
  absl::StatusOr<std::unique_ptr<Cost>> cost =
      Bind(EdgeFromText(facts.name(), example.call), {text->scene, text->zone_centers});
  Bound bound{std::shared_ptr<Cost>(*std::move(cost)), {}};
  for (int i : bound.cost->objects()) bound.poses.push_back(text->layout[static_cast<size_t>(i)]);
  return bound;
}

void RunValue(benchmark::State& state, const Bound& bound) {
  for (auto _ : state) benchmark::DoNotOptimize(bound.cost->Value(bound.poses));
}

void RunGradient(benchmark::State& state, const Bound& bound) {
  std::vector<double> gradient(3 * bound.poses.size());
  for (auto _ : state) {
    benchmark::DoNotOptimize(bound.cost->Gradient(bound.poses, gradient));
    benchmark::ClobberMemory();
  }
}

const bool kRegistered = [] {
  for (const ConstraintFacts& facts : AllConstraints()) {
    for (const LayoutExample& example : facts.layouts) {
      if (example.satisfied) continue;
      const Bound bound = BindExample(facts, example);
      benchmark::RegisterBenchmark((facts.name() + "/value").c_str(), RunValue, bound);
      benchmark::RegisterBenchmark((facts.name() + "/gradient").c_str(), RunGradient, bound);
      break;
    }
  }
  return true;
}();

}  // namespace
}  // namespace flair::optimizer
