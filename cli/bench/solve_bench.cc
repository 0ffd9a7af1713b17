// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/solve_bench.h"

#include <algorithm>
#include <functional>
#include <vector>

#include "cli/bench/statistics.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

template <typename Message>  // SolvedLayout or EvaluateResponse
Quality QualityOf(const Message& message) {
  Quality quality{message.metrics(), 0, 0, 0};
  for (const v1::EdgeOutcome& edge : message.edge_outcomes()) {
    quality.held += edge.status() == v1::OUTCOME_STATUS_SATISFIED;
    quality.missed += edge.status() == v1::OUTCOME_STATUS_VIOLATED;
    quality.dropped += edge.status() == v1::OUTCOME_STATUS_DROPPED;
  }
  return quality;
}

// The first stage whose account differs; the metrics and outcomes come after all stages.
std::string FirstDifference(const v1::SolvedLayout& a, const v1::SolvedLayout& b) {
  const int count = std::min(a.stage_outcomes_size(), b.stage_outcomes_size());
  for (int i = 0; i < count; ++i) {
    const v1::StageOutcome& stage = a.stage_outcomes(i);
    if (stage.SerializeAsString() != b.stage_outcomes(i).SerializeAsString()) return stage.stage();
  }
  return "report";
}

std::optional<Quality> MeasureRecorded(const BenchProblem& problem, const v1::SolveOptions& options,
                                       const optimizer::Solver& solver) {
  if (!problem.recorded) return std::nullopt;
  v1::EvaluateRequest request;
  request.set_request_id("flair-bench");
  *request.mutable_layout_graph() = problem.graph;
  *request.mutable_placements() = problem.recorded->placements();
  *request.mutable_options() = options;
  const absl::StatusOr<v1::EvaluateResponse> response = optimizer::EvaluateLayout(request, solver);
  if (!response.ok()) return std::nullopt;
  return QualityOf(*response);
}

using Measures = std::vector<SolveMeasure>;
using Figure = std::function<double(const SolveMeasure&)>;

std::vector<double> Collect(const Measures& measures, const Figure& figure) {
  std::vector<double> values;
  for (const SolveMeasure& measure : measures) values.push_back(figure(measure));
  return values;
}

double HeldShare(const Quality& quality) {
  return static_cast<double>(quality.held) / std::max(1, quality.held + quality.missed);
}

// "name 1.23, name 1.11, name 0.9": the worst three of those that are not perfect.
std::string Worst(const Measures& measures, const Figure& figure, const char* form, double perfect) {
  std::vector<std::pair<double, std::string>> order;
  for (const SolveMeasure& m : measures) {
    if (std::abs(figure(m) - perfect) > 1e-9) order.emplace_back(std::abs(figure(m) - perfect), m.name);
  }
  std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::string text;
  for (size_t i = 0; i < std::min<size_t>(3, order.size()); ++i) {
    const double value = perfect > 0 ? perfect - order[i].first : order[i].first;
    text += fmt::format("{}{} {}", i > 0 ? ", " : "", order[i].second, fmt::format(fmt::runtime(form), value));
  }
  return text.empty() ? "none" : text;
}

std::string WorstRooms(const Measures& measures) {
  const auto metric = [](const MetricColumn& column) {
    return [&column](const SolveMeasure& m) { return column.of(m.quality.metrics); };
  };
  std::string text = "worst rooms, and what they have\n";
  const auto line = [&](const char* name, const Figure& figure, const char* form, double perfect) {
    text += fmt::format("  {:<24} {}\n", name, Worst(measures, figure, form, perfect));
  };
  line(
      "CPU time, s", [](const SolveMeasure& m) { return m.cpu_s; }, "{:.3f}", 0);
  line(
      "missed constraints", [](const SolveMeasure& m) { return m.quality.missed; }, "{:.0f}", 0);
  for (const MetricColumn& column : kMetrics)
    line(column.title, metric(column), "{:.4g}", column.less_is_better ? 0 : 1);
  return text;
}

// The measures beside those of the recorded layouts, over the rooms that have one.
std::string BesideRecorded(const Measures& all) {
  Measures paired;
  std::copy_if(all.begin(), all.end(), std::back_inserter(paired),
               [](const SolveMeasure& m) { return m.recorded.has_value(); });
  if (paired.empty()) return "";
  const TextTable table({fmt::format("mean over {} with a recorded layout", Counted(std::ssize(paired), "room")),
                         "ours", "recorded", "ratio", "ours no worse in"},
                        46, 9);
  std::string text = table.Header();
  const auto row = [&](const std::string& name, bool less_is_better, const std::function<double(const Quality&)>& of) {
    const double ours = Mean(Collect(paired, [&](const SolveMeasure& m) { return of(m.quality); }));
    const double theirs = Mean(Collect(paired, [&](const SolveMeasure& m) { return of(*m.recorded); }));
    const auto no_worse = std::count_if(paired.begin(), paired.end(), [&](const SolveMeasure& m) {
      const double difference = of(m.quality) - of(*m.recorded);
      return less_is_better ? difference <= 1e-9 : difference >= -1e-9;
    });
    text += table.Row({name, fmt::format("{:.4f}", ours), fmt::format("{:.4f}", theirs),
                       theirs > 0 ? fmt::format("{:.3f}", ours / theirs) : "", Counted(no_worse, "room")});
  };
  row("share of constraints that hold, by our terms", false, HeldShare);
  for (const MetricColumn& column : kMetrics) {
    row(column.title, column.less_is_better, [&](const Quality& quality) { return column.of(quality.metrics); });
  }
  return text;
}

using nlohmann::ordered_json;

ordered_json QualityToJson(const Quality& quality) {
  ordered_json json{{"held", quality.held}, {"missed", quality.missed}, {"dropped", quality.dropped}};
  for (const MetricColumn& column : kMetrics) json[column.name] = column.of(quality.metrics);
  return json;
}

// The constraints that do not hold, and why.
ordered_json MissedToJson(const v1::SolvedLayout& layout) {
  ordered_json missed = ordered_json::array();
  for (int i = 0; i < layout.edge_outcomes_size() && i < layout.graph().edges_size(); ++i) {
    const v1::EdgeOutcome& edge = layout.edge_outcomes(i);
    if (edge.status() != v1::OUTCOME_STATUS_VIOLATED) continue;
    missed.push_back({{"edge", edge.edge_id()},
                      {"type", layout.graph().edges(i).type()},
                      {"cost", edge.cost()},
                      {"reason", edge.reason()}});
  }
  return missed;
}

ordered_json RoomToJson(const SolveMeasure& m) {
  ordered_json room{{"name", m.name},
                    {"objects", m.object_count()},
                    {"cpu_s", m.cpu_s},
                    {"wall_s", m.wall_s},
                    {"restarts", m.restart_count()},
                    {"evaluations", m.evaluation_count()},
                    {"total_cost", m.layout.total_cost()}};
  for (size_t s = 0; s < kStages.size(); ++s) {
    room["stages"][std::string(optimizer::StageName(kStages[s]))] = {{"cost", m.CostOf(kStages[s])},
                                                                     {"restarts", m.stages[s].restarts},
                                                                     {"evaluations", m.stages[s].evaluations},
                                                                     {"cpu_s", m.stages[s].cpu_s}};
  }
  room["ours"] = QualityToJson(m.quality);
  if (m.recorded) room["recorded"] = QualityToJson(*m.recorded);
  room["missed"] = MissedToJson(m.layout);
  return room;
}

}  // namespace

absl::StatusOr<std::vector<optimizer::RestartResult>> CountingRunner::Run(const optimizer::SolveInput& input,
                                                                          const optimizer::StageSpec& stage,
                                                                          const optimizer::PartialLayout& before,
                                                                          int first, int count) const {
  const double started = ThreadCpu_s();
  absl::StatusOr<std::vector<optimizer::RestartResult>> results = local_.Run(input, stage, before, first, count);
  const double cpu_s = ThreadCpu_s() - started;
  if (!results.ok()) return results;
  const std::lock_guard lock(mutex_);
  StageTally& tally = tallies_[static_cast<size_t>(stage.kind)];
  tally.cpu_s += cpu_s;
  tally.restarts += static_cast<int64_t>(results->size());
  for (const optimizer::RestartResult& result : *results) tally.evaluations += result.evaluations;
  return results;
}

std::array<StageTally, kStages.size()> CountingRunner::Tallies() const {
  const std::lock_guard lock(mutex_);
  return tallies_;
}

int64_t SolveMeasure::restart_count() const {
  int64_t count = 0;
  for (const StageTally& stage : stages) count += stage.restarts;
  return count;
}

int64_t SolveMeasure::evaluation_count() const {
  int64_t count = 0;
  for (const StageTally& stage : stages) count += stage.evaluations;
  return count;
}

double SolveMeasure::CostOf(optimizer::StageKind stage) const {
  double cost = 0;
  for (const v1::StageOutcome& outcome : layout.stage_outcomes()) {
    if (outcome.stage() == optimizer::StageName(stage)) cost += outcome.cost();
  }
  return cost;
}

absl::StatusOr<SolveMeasure> MeasureSolve(const BenchProblem& problem, const v1::SolveOptions& options, int repeats) {
  SolveMeasure measure;
  measure.name = problem.name;
  const optimizer::NloptSolver solver;
  std::vector<double> cpu_s, wall_s;
  std::array<std::vector<double>, kStages.size()> stage_cpu_s;
  for (int i = 0; i < repeats; ++i) {
    const CountingRunner runner;
    const double cpu = ProcessCpu_s(), wall = Wall_s();
    absl::StatusOr<optimizer::SolveResult> result =
        optimizer::SolveLayout(problem.graph, options, solver, nullptr, runner);
    cpu_s.push_back(ProcessCpu_s() - cpu);
    wall_s.push_back(Wall_s() - wall);
    if (!result.ok()) return result.status();
    if (i > 0 && result->layout.SerializeAsString() != measure.layout.SerializeAsString()) {
      return absl::InternalError(
          fmt::format("solve {} of {} gave another layout than the ones before, from stage {} on", i + 1, repeats,
                      FirstDifference(measure.layout, result->layout)));
    }
    measure.layout = std::move(result->layout);
    measure.stages = runner.Tallies();
    for (size_t s = 0; s < kStages.size(); ++s) stage_cpu_s[s].push_back(measure.stages[s].cpu_s);
  }
  measure.cpu_s = Quantile(cpu_s, 0.5);
  measure.wall_s = Quantile(wall_s, 0.5);
  for (size_t s = 0; s < kStages.size(); ++s) measure.stages[s].cpu_s = Quantile(stage_cpu_s[s], 0.5);
  measure.quality = QualityOf(measure.layout);
  measure.recorded = MeasureRecorded(problem, options, solver);
  return measure;
}

std::string SolveLegend() {
  return "CPU ms    of a solve, all threads; runs and evals k: its restarts and thousands of evaluations\n"
         "primary.. cost at the end of each stage, of the branch that won\n"
         "OOB, OOR  area outside the room and in other things or door swings, percent of the room; deep: deepest "
         "overlap\n"
         "floor     share of the free floor that can be reached from the door; fronts: share of the objects' fronts\n"
         "path m3   pathway cost: how much stands in the ways; held, missed: constraints\n"
         "rec       the same of the layout that the problem was recorded with\n\n";
}

TextTable SolveTable(size_t name_width) {
  return TextTable({"room", "objs", "CPU ms", "runs", "evals k", "primary", "second", "polish", "tertiary", "OOB %",
                    "OOR %", "deep mm", "floor", "fronts", "path m3", "held", "missed", "rec path", "rec held"},
                   name_width);
}

std::vector<std::string> SolveCells(const SolveMeasure& m) {
  const v1::LayoutMetrics& metrics = m.quality.metrics;
  std::vector<std::string> cells = {m.name, fmt::format("{}", m.object_count()), fmt::format("{:.0f}", 1e3 * m.cpu_s),
                                    fmt::format("{}", m.restart_count()),
                                    fmt::format("{:.0f}", 1e-3 * static_cast<double>(m.evaluation_count()))};
  for (const optimizer::StageKind stage : kStages) cells.push_back(fmt::format("{:.3f}", m.CostOf(stage)));
  for (const std::string& cell :
       {fmt::format("{:.4f}", metrics.oob_percent()), fmt::format("{:.4f}", metrics.oor_percent()),
        fmt::format("{:.3f}", 1e3 * metrics.deepest_overlap_m()),
        fmt::format("{:.3f}", metrics.reachable_floor_share()), fmt::format("{:.3f}", metrics.reachable_front_share()),
        fmt::format("{:.4f}", metrics.pathway_cost_m3()), fmt::format("{}", m.quality.held),
        fmt::format("{}", m.quality.missed),
        m.recorded ? fmt::format("{:.4f}", m.recorded->metrics.pathway_cost_m3()) : "-",
        m.recorded ? fmt::format("{}", m.recorded->held) : "-"}) {
    cells.push_back(cell);
  }
  return cells;
}

std::string SolveSummary(const Measures& measures, double memory_before_MiB) {
  int held = 0, missed = 0;
  for (const SolveMeasure& m : measures) {
    held += m.quality.held;
    missed += m.quality.missed;
  }
  const std::vector<double> cpu_s = Collect(measures, [](const SolveMeasure& m) { return m.cpu_s; });
  const double restarts = Mean(Collect(measures, [](const SolveMeasure& m) { return m.restart_count(); }));
  const double evaluations = Mean(Collect(measures, [](const SolveMeasure& m) { return m.evaluation_count(); }));
  std::string text = fmt::format(
      "\n{}: CPU median {:.3f} s, mean {:.3f} s, 95th percentile {:.3f} s, most {:.3f} s\n"
      "restarts {:.1f}, evaluations {:.0f} k a room; {} of {} ({:.1f} %)\n"
      "memory of the process: {:.1f} MiB before the first solve, {:.1f} MiB at most\n\n",
      Counted(std::ssize(measures), "room"), Quantile(cpu_s, 0.5), Mean(cpu_s), Quantile(cpu_s, 0.95),
      Quantile(cpu_s, 1), restarts, 1e-3 * evaluations, held,
      Counted(held + missed, "constraint holds", "constraints hold"), 100.0 * held / std::max(1, held + missed),
      memory_before_MiB, PeakMemory_MiB());
  const TextTable stages({"stage", "CPU ms", "share", "runs", "evals k"}, 10, 8);
  text += "mean per room\n" + stages.Header();
  for (size_t s = 0; s < kStages.size(); ++s) {
    const auto mean = [&](const auto& of) {
      return Mean(Collect(measures, [&](const auto& m) { return of(m.stages[s]); }));
    };
    const double stage_cpu_s = mean([](const StageTally& t) { return t.cpu_s; });
    text += stages.Row({std::string(optimizer::StageName(kStages[s])), fmt::format("{:.1f}", 1e3 * stage_cpu_s),
                        fmt::format("{:.0f} %", 100 * stage_cpu_s / std::max(1e-9, Mean(cpu_s))),
                        fmt::format("{:.1f}", mean([](const StageTally& t) { return t.restarts; })),
                        fmt::format("{:.0f}", 1e-3 * mean([](const StageTally& t) { return t.evaluations; }))});
  }
  return text + "\n" + WorstRooms(measures) + "\n" + BesideRecorded(measures);
}

std::string SolveMeasuresToJson(const std::vector<SolveMeasure>& measures, const std::vector<BenchFailure>& failures,
                                double memory_before_MiB) {
  ordered_json json{{"rooms", ordered_json::array()}, {"failures", ordered_json::array()}};
  std::vector<double> cpu_s;
  for (const SolveMeasure& m : measures) {
    json["rooms"].push_back(RoomToJson(m));
    cpu_s.push_back(m.cpu_s);
  }
  for (const BenchFailure& failure : failures) {
    json["failures"].push_back({{"file", failure.file}, {"reason", failure.reason}});
  }
  json["summary"] = {{"rooms", measures.size()},           {"cpu_median_s", Quantile(cpu_s, 0.5)},
                     {"cpu_mean_s", Mean(cpu_s)},          {"cpu_p95_s", Quantile(cpu_s, 0.95)},
                     {"cpu_most_s", Quantile(cpu_s, 1)},   {"memory_before_mib", memory_before_MiB},
                     {"memory_peak_mib", PeakMemory_MiB()}};
  return json.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace flair::cli
