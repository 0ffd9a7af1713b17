// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a solve, from one evaluation to the whole, on recorded problems: the first three of the folder that
// FLAIR_BENCH_ROOMS names, else the small one of the readers' tests.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>

#include "evaluation/metrics/layout_metrics.h"
#include "evaluation/metrics/measures.h"
#include "evaluation/metrics/walk_grid.h"
#include "evaluation/readers/flairgpt_calls.h"
#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "optimizer_worker/stages/stage.h"
#include "room/conversion/conversion.h"

namespace flair::optimizer {
namespace {

constexpr size_t kRooms = 3;

v1::SolveOptions Threads(int count) {
  v1::SolveOptions options;
  options.set_seed(0);
  options.set_thread_count(count);
  return options;
}

// One problem, taken as far as each benchmark needs it. Not movable: the input refers to the graph.
struct Bench {
  explicit Bench(v1::LayoutGraph problem)
      : graph(std::move(problem)),
        input(MakeSolveInput(graph, Threads(1), solver, nullptr).value()),
        primary(MakeStage(input.scene, StageKind::kPrimary)),
        after_primary(RunRestarts(input, primary, PartialLayout(input.scene), 0, 1)->front().state),
        solved(SolveLayout(graph, Threads(1), solver)->layout) {
    for (int zone = 0; zone < static_cast<int>(input.scene.zones.size()); ++zone) {
      const StageSpec stage = MakeStage(input.scene, StageKind::kSecondary, zone);
      if (stage.objects.size() > secondary.objects.size()) secondary = stage;
    }
  }

  const NloptSolver solver;
  const v1::LayoutGraph graph;
  const SolveInput input;
  const StageSpec primary;
  const PartialLayout after_primary;
  const v1::SolvedLayout solved;
  // The zone with most objects.
  StageSpec secondary;
};

// The objective of the largest secondary stage, all of its objects free and where a restart leaves them.
struct SecondaryObjective {
  explicit SecondaryObjective(const Bench& bench)
      : costs(BindCosts(bench.input,
                        ZoneCenters(bench.input.scene, bench.after_primary.placed, bench.after_primary.layout))),
        problem(MakeProblem(bench.input, costs, bench.secondary, bench.after_primary)),
        poses(RunRestarts(bench.input, bench.secondary, bench.after_primary, 0, 1)->front().state.layout) {
    for (int object : bench.secondary.objects) problem.SetPlaced(object, true);
    // Off the optimum, where terms are not zero.
    for (int object : bench.secondary.objects) poses[object].x_m += 0.07, poses[object].theta_rad += 0.1;
    objective = std::make_unique<ProblemObjective>(problem, poses, bench.secondary.objects, true);
  }
  const SceneCosts costs;
  Problem problem;
  Layout poses;
  std::unique_ptr<ProblemObjective> objective;
};

void SecondaryEvaluate(benchmark::State& state, const Bench& bench) {
  SecondaryObjective stage(bench);
  std::vector<double> x = stage.objective->Start(), gradient(x.size());
  for (auto _ : state) {
    // All objects move in every evaluation, as in a descent.
    for (double& value : x) value += 1e-9;
    benchmark::DoNotOptimize(stage.objective->Evaluate(x, gradient));
  }
  state.counters["objects"] = static_cast<double>(bench.secondary.objects.size());
}

void SlsqpIteration(benchmark::State& state, const Bench& bench) {
  SecondaryObjective stage(bench);
  const std::vector<double> start = stage.objective->Start();
  int64_t evaluations = 0;
  for (auto _ : state) {
    std::vector<double> x = start;
    const SolverLimits limits{
        .max_evaluations = 10, .relative_tolerance = 0, .absolute_tolerance = 0, .good_enough = -1};
    evaluations += bench.solver.Minimize(*stage.objective, {}, limits, x).evaluations;
  }
  // Time of an iteration: the descent over its evaluations.
  state.counters["per_iteration"] =
      benchmark::Counter(static_cast<double>(evaluations), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void PrimaryRestart(benchmark::State& state, const Bench& bench) {
  int restart = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        RunRestarts(bench.input, bench.primary, PartialLayout(bench.input.scene), restart++ % 8, 1));
  }
}

// 32 primary restarts on as many threads as the argument says; compare the wall times.
void RestartsOnThreads(benchmark::State& state, const Bench& bench) {
  const SolveInput input =
      MakeSolveInput(bench.graph, Threads(static_cast<int>(state.range(0))), bench.solver, nullptr).value();
  for (auto _ : state) benchmark::DoNotOptimize(RunRestarts(input, bench.primary, PartialLayout(input.scene), 0, 32));
}

void WholeSolve(benchmark::State& state, const Bench& bench) {
  for (auto _ : state) benchmark::DoNotOptimize(SolveLayout(bench.graph, Threads(1), bench.solver));
}

template <typename Measure>
void MeasureSolved(benchmark::State& state, const Bench& bench, const Measure& measure) {
  const flair::PartialLayout poses = PosesFromPlacements(bench.input.scene, bench.solved.placements()).value();
  const evaluation::LayoutView view(bench.input.scene, poses.layout, poses.placed);
  for (auto _ : state) benchmark::DoNotOptimize(measure(view));
}

void Register(const std::string& name, const std::shared_ptr<Bench>& bench) {
  const auto add = [&](const char* what, const auto& run) {
    return benchmark::RegisterBenchmark((name + "/" + what).c_str(),
                                        [bench, run](benchmark::State& state) { run(state, *bench); });
  };
  if (!bench->secondary.objects.empty()) {
    add("secondary_objective_value_and_gradient", SecondaryEvaluate);
    add("slsqp", SlsqpIteration);
  }
  add("primary_restart", PrimaryRestart)->Unit(benchmark::kMillisecond);
  add("primary_restarts_32", RestartsOnThreads)
      ->Arg(1)
      ->Arg(2)
      ->Arg(4)
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime()
      ->MeasureProcessCPUTime();
  add("whole_solve", WholeSolve)->Unit(benchmark::kMillisecond);
  const auto metric = [&](const char* what, const auto& measure) {
    add(what, [measure](benchmark::State& state, const Bench& b) { MeasureSolved(state, b, measure); });
  };
  metric("metrics_oob", [](const auto& view) { return evaluation::OobPercent(view); });
  metric("metrics_oor", [](const auto& view) { return evaluation::OorPercent(view); });
  metric("metrics_reach", [](const auto& view) { return evaluation::MeasureReach(view).floor_share; });
  metric("metrics_pathway", [](const auto& view) { return evaluation::PathwayCost_m3(view); });
  metric("metrics_all", [](const auto& view) { return evaluation::MeasureLayout(view).oob_percent(); });
}

std::vector<std::filesystem::path> Files() {
  const char* folder = std::getenv("FLAIR_BENCH_ROOMS");
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(
           folder != nullptr ? folder : FLAIR_SOURCE_DIR "/evaluation/readers/testdata")) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  if (files.size() > kRooms) files.resize(kRooms);
  return files;
}

const bool kRegistered = [] {
  for (const std::filesystem::path& path : Files()) {
    std::ifstream file(path);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    Register(path.stem().string(), std::make_shared<Bench>(evaluation::ReadFlairGptRoom(text).value()));
  }
  return true;
}();

}  // namespace
}  // namespace flair::optimizer
