// SPDX-License-Identifier: GPL-3.0-or-later
// A layout of five megabytes, as large as validation lets its parts be: read in each of its forms, told, searched. What
// `flair inspect` adds to these is the start of the program.
#include <benchmark/benchmark.h>

#include <string>

#include "cli/input/artifact_file.h"
#include "cli/inspect/field.h"
#include "cli/inspect/inspection.h"
#include "cli/output/artifact_text.h"
#include "fmt/format.h"
#include "orchestrator/store/artifact_id.h"
#include "tests/fixtures/bedroom.h"

namespace flair::cli {
namespace {

constexpr size_t kBytes = 5'000'000;
constexpr int kObjects = 200;
constexpr int kEdges = 3000;

v1::Placement PlacementOf(const std::string& id, int i) {
  v1::Placement placement;
  placement.set_object_id(id);
  placement.set_x_m(0.01 * i);
  placement.set_y_m(0.02 * i);
  placement.set_theta_rad(0.03 * (i % 200));
  return placement;
}

// Objects, sentences, calls and outcomes; then runner-ups until it is large enough.
v1::SolvedLayout LargeLayout() {
  v1::SolvedLayout layout;
  v1::LayoutGraph& graph = *layout.mutable_graph();
  graph = testing::BedroomGraph();
  graph.clear_edges();
  graph.mutable_constraint_list()->clear_sentences();
  graph.mutable_object_list()->clear_objects();
  for (int i = 0; i < kObjects; ++i) {
    v1::Object& object = *graph.mutable_object_list()->add_objects() = testing::BedroomBed(fmt::format("bed_{}", i));
    object.set_description(std::string(200, 'd'));
    *layout.add_placements() = PlacementOf(object.id(), i);
  }
  for (int i = 0; i < kEdges; ++i) {
    const std::string bed = fmt::format("bed_{}", i % kObjects);
    v1::Sentence& sentence = *graph.mutable_constraint_list()->add_sentences() = testing::BedroomSentence(bed);
    sentence.set_id(fmt::format("s{}", i));
    sentence.set_reason(std::string(200, 'r'));
    v1::ConstraintEdge& edge = *graph.add_edges() = testing::BedroomEdge(bed);
    edge.set_id(fmt::format("e{}", i));
    edge.set_sentence_id(sentence.id());
    v1::EdgeOutcome& outcome = *layout.add_edge_outcomes();
    outcome.set_edge_id(edge.id());
    outcome.set_status(i % 3 == 0 ? v1::OUTCOME_STATUS_VIOLATED : v1::OUTCOME_STATUS_SATISFIED);
    outcome.set_weighted_cost(0.001 * (i % 77));
    outcome.set_reason(std::string(120, 'm'));
  }
  v1::RunnerUp other;
  *other.mutable_placements() = layout.placements();
  *other.mutable_edge_outcomes() = layout.edge_outcomes();
  while (layout.ByteSizeLong() < kBytes) *layout.add_runner_ups() = other;
  return layout;
}

const v1::Artifact& Large() {
  static const v1::Artifact artifact = [] {
    v1::Artifact made;
    *made.mutable_solved_layout() = LargeLayout();
    made.set_id(orchestrator::ComputeArtifactId(made));
    return made;
  }();
  return artifact;
}

void Read(benchmark::State& state, const char* name, const std::string& bytes) {
  for (auto _ : state) {
    const absl::StatusOr<ArtifactFile> file = ParseArtifactFile(name, bytes);
    if (!file.ok() || !file->good.ok() || file->edited) state.SkipWithError("not read");
    benchmark::DoNotOptimize(file);
  }
  state.counters["MB"] = 1e-6 * static_cast<double>(bytes.size());
}

void ReadBinary(benchmark::State& state) { Read(state, "layout.pb", ArtifactBytes(Large())); }
void ReadJson(benchmark::State& state) { Read(state, "layout.json", ToJson(Large())); }
void ReadProtobufText(benchmark::State& state) { Read(state, "layout.textproto", ToText(Large())); }

void ReadAndTell(benchmark::State& state) {
  const std::string bytes = ArtifactBytes(Large());
  const std::unique_ptr<ArtifactShelf> shelf = MakeStoreShelf("");
  for (auto _ : state) {
    const absl::StatusOr<ArtifactFile> file = ParseArtifactFile("layout.pb", bytes);
    ArtifactFinder finder("", *shelf);
    benchmark::DoNotOptimize(InspectionText("layout.pb", *file, finder, {}));
  }
}

void WriteJson(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(ToJson(Large()));
}

void FindOneField(benchmark::State& state) {
  for (auto _ : state) {
    const absl::StatusOr<FieldView> view = FindField(Large(), "solved_layout.placements[bed_199].theta_rad");
    benchmark::DoNotOptimize(FieldText(*view, FieldFormat::kText));
  }
}

BENCHMARK(ReadBinary)->Unit(benchmark::kMillisecond);
BENCHMARK(ReadJson)->Unit(benchmark::kMillisecond);
BENCHMARK(ReadProtobufText)->Unit(benchmark::kMillisecond);
BENCHMARK(ReadAndTell)->Unit(benchmark::kMillisecond);
BENCHMARK(WriteJson)->Unit(benchmark::kMillisecond);
BENCHMARK(FindOneField)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace flair::cli
