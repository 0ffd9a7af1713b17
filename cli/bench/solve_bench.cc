// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <mutex>

#include "cli/bench/bench.h"
#include "cli/output/message_view.h"
#include "fmt/format.h"
#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

constexpr std::array kStages = {optimizer::StageKind::kPrimary, optimizer::StageKind::kSecondary,
                                optimizer::StageKind::kPolish, optimizer::StageKind::kTertiary};

std::string NameOf(optimizer::StageKind stage) { return std::string(optimizer::StageName(stage)); }

struct StageTally {
  int64_t restarts = 0;
  int64_t evaluations = 0;
  // CPU time of the threads that called; all of it when the solve has one thread.
  double cpu_s = 0;
};
using StageTallies = std::array<StageTally, kStages.size()>;

// Runs restarts on this process's threads and counts them by stage. Thread-safe.
class CountingRunner final : public optimizer::RestartRunner {
 public:
  absl::StatusOr<std::vector<optimizer::RestartResult>> Run(const optimizer::SolveInput& input,
                                                            const optimizer::StageSpec& stage,
                                                            const optimizer::PartialLayout& before, int first,
                                                            int count) const override {
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
  // In the order of kStages. After the solve.
  const StageTallies& tallies() const { return tallies_; }

 private:
  const optimizer::LocalRestartRunner local_;
  mutable std::mutex mutex_;
  mutable StageTallies tallies_;
};

// One of the measures of a layout: its name in LayoutMetrics, what people read, and which end is good.
struct Metric {
  const char* name;
  const char* title;
  bool less_is_better;
};
constexpr Metric kMetrics[] = {{"oob_percent", "OOB, % of the room", true},
                               {"oor_percent", "OOR, % of the room", true},
                               {"deepest_overlap_m", "deepest overlap, m", true},
                               {"oob_3d_percent", "OOB in 3D, % of the volume", true},
                               {"oor_3d_percent", "OOR in 3D, % of the volume", true},
                               {"reachable_floor_share", "reachable floor, share", false},
                               {"reachable_front_share", "reachable fronts, share", false},
                               {"pathway_cost_m3", "pathway cost, m3", true}};

// Verdicts and measures of a SolvedLayout or an EvaluateResponse.
template <typename Message>
Record QualityOf(const Message& message) {
  const auto count = [&message](v1::OutcomeStatus status) {
    return std::ranges::count(message.edge_outcomes(), status, &v1::EdgeOutcome::status);
  };
  // Dropped are calls that no term could be made of.
  Record quality{{"held", count(v1::OUTCOME_STATUS_SATISFIED)},
                 {"missed", count(v1::OUTCOME_STATUS_VIOLATED)},
                 {"dropped", count(v1::OUTCOME_STATUS_DROPPED)}};
  const v1::LayoutMetrics& metrics = message.metrics();
  for (const Metric& metric : kMetrics) {
    const auto* const field = metrics.GetDescriptor()->FindFieldByName(metric.name);
    quality[metric.name] = metrics.GetReflection()->GetDouble(metrics, field);
  }
  quality["use_count"] = metrics.use_count();
  quality["met_use_count"] = metrics.met_use_count();
  quality["findings"] = Record::array();
  for (const v1::Finding& finding : metrics.findings()) {
    quality["findings"].push_back({{"kind", EnumInWords(finding.kind())}, {"message", finding.message()}});
  }
  return quality;
}

// The layout that the problem came with, by our own measures.
void MeasureRecorded(const BenchProblem& problem, const v1::SolveOptions& options, const optimizer::Solver& solver,
                     Record& record) {
  if (!problem.recorded) return;
  v1::EvaluateRequest request;
  request.set_request_id("flair-bench");
  *request.mutable_layout_graph() = problem.graph;
  *request.mutable_placements() = problem.recorded->placements();
  *request.mutable_options() = options;
  const absl::StatusOr<v1::EvaluateResponse> response = optimizer::EvaluateLayout(request, solver);
  if (response.ok()) record["recorded"] = QualityOf(*response);
}

// The constraints that do not hold, and why.
Record MissedOf(const v1::SolvedLayout& layout) {
  Record missed = Record::array();
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

// Sum of the costs of a stage's outcomes, of the branch that won.
double CostOf(const v1::SolvedLayout& layout, const std::string& stage) {
  double cost = 0;
  for (const v1::StageOutcome& outcome : layout.stage_outcomes()) {
    if (outcome.stage() == stage) cost += outcome.cost();
  }
  return cost;
}

// `stage_cpu_s` of each repeat; all else is the same in all of them.
Record StagesOf(const v1::SolvedLayout& layout, const StageTallies& tallies,
                const std::array<std::vector<double>, kStages.size()>& stage_cpu_s) {
  Record stages;
  for (size_t s = 0; s < kStages.size(); ++s) {
    stages[NameOf(kStages[s])] = {{"cost", CostOf(layout, NameOf(kStages[s]))},
                                  {"restarts", tallies[s].restarts},
                                  {"evaluations", tallies[s].evaluations},
                                  {"cpu_s", Quantile(stage_cpu_s[s], 0.5)}};
  }
  return stages;
}

// The measures beside those of the recorded layouts, over the rooms that have one.
std::string BesideRecorded(const std::vector<Record>& all) {
  std::vector<Record> paired;
  std::ranges::copy_if(all, std::back_inserter(paired), [](const Record& solve) { return solve.contains("recorded"); });
  if (paired.empty()) return "";
  const TextTable table({fmt::format("mean over {} with a recorded layout", Counted(std::ssize(paired), "room")),
                         "ours", "recorded", "ratio", "ours no worse in"},
                        46, 9);
  std::string text = table.Header();
  const auto row = [&](const std::string& name, bool less_is_better, const auto& of) {
    std::vector<double> ours, theirs;
    int no_worse = 0;
    for (const Record& solve : paired) {
      ours.push_back(of(solve["ours"]));
      theirs.push_back(of(solve["recorded"]));
      const double difference = ours.back() - theirs.back();
      no_worse += less_is_better ? difference <= 1e-9 : difference >= -1e-9;
    }
    text += table.Row({name, fmt::format("{:.4f}", Mean(ours)), fmt::format("{:.4f}", Mean(theirs)),
                       Mean(theirs) > 0 ? fmt::format("{:.3f}", Mean(ours) / Mean(theirs)) : "",
                       Counted(no_worse, "room")});
  };
  row("share of constraints that hold, by our terms", false, [](const Record& quality) {
    const double held = quality["held"], missed = quality["missed"];
    return held / std::max(1.0, held + missed);
  });
  for (const Metric& metric : kMetrics) {
    row(metric.title, metric.less_is_better, [&](const Record& quality) { return quality[metric.name].get<double>(); });
  }
  return text;
}

constexpr Figure kFigures[] = {{"objs", "/objects"},
                               {"CPU ms", "/cpu_s", 0, 1e3},
                               {"runs", "/restarts"},
                               {"evals k", "/evaluations", 0, 1e-3},
                               {"primary", "/stages/primary/cost", 3},
                               {"second", "/stages/secondary/cost", 3},
                               {"polish", "/stages/polish/cost", 3},
                               {"tertiary", "/stages/tertiary/cost", 3},
                               {"OOB %", "/ours/oob_percent", 4},
                               {"OOR %", "/ours/oor_percent", 4},
                               {"deep mm", "/ours/deepest_overlap_m", 3, 1e3},
                               {"floor", "/ours/reachable_floor_share", 3},
                               {"fronts", "/ours/reachable_front_share", 3},
                               {"path m3", "/ours/pathway_cost_m3", 4},
                               {"held", "/ours/held"},
                               {"missed", "/ours/missed"},
                               {"rec path", "/recorded/pathway_cost_m3", 4},
                               {"rec held", "/recorded/held"}};

}  // namespace

absl::StatusOr<SolveMeasure> MeasureSolve(const BenchProblem& problem, const v1::SolveOptions& options, int repeats) {
  SolveMeasure measure;
  const optimizer::NloptSolver solver;
  std::vector<double> cpu_s, wall_s;
  std::array<std::vector<double>, kStages.size()> stage_cpu_s;
  StageTallies tallies;
  for (int i = 0; i < repeats; ++i) {
    const CountingRunner runner;
    const double cpu = ProcessCpu_s(), wall = Wall_s();
    absl::StatusOr<optimizer::SolveResult> result =
        optimizer::SolveLayout(problem.graph, options, solver, nullptr, runner);
    cpu_s.push_back(ProcessCpu_s() - cpu);
    wall_s.push_back(Wall_s() - wall);
    if (!result.ok()) return result.status();
    if (i > 0 && result->layout.SerializeAsString() != measure.layout.SerializeAsString()) {
      return Internal("solve {} of {} gave another layout than the ones before", i + 1, repeats);
    }
    measure.layout = std::move(result->layout);
    tallies = runner.tallies();
    for (size_t s = 0; s < kStages.size(); ++s) stage_cpu_s[s].push_back(tallies[s].cpu_s);
  }
  int64_t restarts = 0, evaluations = 0;
  for (const StageTally& tally : tallies) {
    restarts += tally.restarts;
    evaluations += tally.evaluations;
  }
  measure.record = {{"name", problem.name},
                    {"objects", problem.graph.object_list().objects_size()},
                    {"cpu_s", Quantile(cpu_s, 0.5)},
                    {"wall_s", Quantile(wall_s, 0.5)},
                    {"restarts", restarts},
                    {"evaluations", evaluations},
                    {"total_cost", measure.layout.total_cost()},
                    {"stages", StagesOf(measure.layout, tallies, stage_cpu_s)},
                    {"ours", QualityOf(measure.layout)}};
  MeasureRecorded(problem, options, solver, measure.record);
  measure.record["missed"] = MissedOf(measure.layout);
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
  std::vector<std::string> titles = {"room"};
  for (const Figure& figure : kFigures) titles.emplace_back(figure.title);
  return TextTable(titles, name_width);
}

std::vector<std::string> SolveCells(const Record& solve) {
  std::vector<std::string> cells = {solve["name"]};
  for (const Figure& figure : kFigures) cells.push_back(CellOf(solve, figure));
  return cells;
}

std::string SolveSummary(const std::vector<Record>& solves, double memory_before_MiB) {
  const auto sum = [&solves](const char* at) {
    return std::llround(Mean(NumbersAt(solves, at)) * static_cast<double>(solves.size()));
  };
  const int64_t held = sum("/ours/held"), judged = held + sum("/ours/missed");
  const std::vector<double> cpu_s = NumbersAt(solves, "/cpu_s");
  std::string text = fmt::format(
      "\n{}: CPU median {:.3f} s, mean {:.3f} s, 95th percentile {:.3f} s, most {:.3f} s\n"
      "restarts {:.1f}, evaluations {:.0f} k a room; {} of {} ({:.1f} %)\n"
      "memory of the process: {:.1f} MiB before the first solve, {:.1f} MiB at most\n\n",
      Counted(std::ssize(solves), "room"), Quantile(cpu_s, 0.5), Mean(cpu_s), Quantile(cpu_s, 0.95), Quantile(cpu_s, 1),
      Mean(NumbersAt(solves, "/restarts")), Mean(NumbersAt(solves, "/evaluations", 1e-3)), held,
      Counted(judged, "constraint holds", "constraints hold"),
      100.0 * static_cast<double>(held) / static_cast<double>(std::max<int64_t>(1, judged)), memory_before_MiB,
      PeakMemory_MiB());
  const TextTable stages({"stage", "CPU ms", "share", "runs", "evals k"}, 10, 8);
  text += "mean per room\n" + stages.Header();
  for (const optimizer::StageKind stage : kStages) {
    const std::string name = NameOf(stage);
    const auto mean = [&](const char* of) { return Mean(NumbersAt(solves, fmt::format("/stages/{}/{}", name, of))); };
    text += stages.Row({name, fmt::format("{:.1f}", 1e3 * mean("cpu_s")),
                        fmt::format("{:.0f} %", 100 * mean("cpu_s") / std::max(1e-9, Mean(cpu_s))),
                        fmt::format("{:.1f}", mean("restarts")), fmt::format("{:.0f}", 1e-3 * mean("evaluations"))});
  }
  return text + "\n" + BesideRecorded(solves);
}

std::string SolvesToJson(const std::vector<Record>& solves, const std::vector<Record>& failures) {
  return RecordText({{"rooms", solves}, {"failures", failures}, {"memory_peak_mib", PeakMemory_MiB()}});
}

}  // namespace flair::cli
