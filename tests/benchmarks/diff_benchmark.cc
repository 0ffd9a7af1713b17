// SPDX-License-Identifier: GPL-3.0-or-later
// flair diff without reading and drawing: two layouts of 60 objects and 150 calls, every one of which moved, and the
// diagram that flair graph gives to Graphviz.
#include <benchmark/benchmark.h>

#include "cli/diff/artifact_difference.h"
#include "cli/graph/dot_text.h"
#include "fmt/format.h"
#include "tests/fixtures/bedroom.h"

namespace flair::cli {
namespace {

constexpr int kObjects = 60;
constexpr int kCalls = 150;

v1::Artifact LayoutWith(double shift_m) {
  v1::Artifact artifact;
  v1::SolvedLayout& layout = *artifact.mutable_solved_layout();
  v1::LayoutGraph& graph = *layout.mutable_graph();
  *graph.mutable_room() = testing::BedroomRoom();
  *graph.mutable_zone_plan() = testing::BedroomZones();
  for (int i = 0; i < kObjects; ++i) {
    v1::Object& object = *graph.mutable_object_list()->add_objects() = testing::BedroomBed(fmt::format("bed_{}", i));
    object.set_width_m(1 + shift_m);
    v1::Placement& place = *layout.add_placements();
    place.set_object_id(object.id());
    place.set_x_m(0.05 * i + shift_m);
    place.set_theta_rad(shift_m);
  }
  for (int i = 0; i < kCalls; ++i) {
    const std::string bed = fmt::format("bed_{}", i % kObjects);
    v1::Sentence& sentence = *graph.mutable_constraint_list()->add_sentences() = testing::BedroomSentence(bed);
    sentence.set_id(fmt::format("s{}", i));
    sentence.set_text(fmt::format("Bed {} is against a wall, {}.", i, shift_m > 0 ? "please" : "surely"));
    v1::ConstraintEdge& edge = *graph.add_edges() = testing::BedroomEdge(bed);
    edge.set_id(fmt::format("e{}", i));
    edge.set_sentence_id(sentence.id());
    v1::EdgeOutcome& outcome = *layout.add_edge_outcomes();
    outcome.set_edge_id(edge.id());
    outcome.set_status(shift_m > 0 ? v1::OUTCOME_STATUS_VIOLATED : v1::OUTCOME_STATUS_SATISFIED);
  }
  return artifact;
}

void CompareLayouts(benchmark::State& state) {
  const v1::Artifact a = LayoutWith(0), b = LayoutWith(0.2);
  for (auto _ : state) {
    const absl::StatusOr<Difference> difference = CompareArtifacts(a, b);
    benchmark::DoNotOptimize(DifferenceText(*difference, "a", "b"));
  }
}
BENCHMARK(CompareLayouts)->Unit(benchmark::kMillisecond);

void DescribeDiagram(benchmark::State& state) {
  const v1::Artifact layout = LayoutWith(0);
  for (auto _ : state) benchmark::DoNotOptimize(DotText(DiagramOf(layout.solved_layout())));
}
BENCHMARK(DescribeDiagram)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace flair::cli
