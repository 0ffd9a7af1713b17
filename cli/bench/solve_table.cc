// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/solve_table.h"

#include <algorithm>
#include <functional>

#include "cli/bench/statistics.h"
#include "fmt/format.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

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
  line("CPU time, s", [](const SolveMeasure& m) { return m.cpu_s; }, "{:.3f}", 0);
  line("missed constraints", [](const SolveMeasure& m) { return m.quality.missed; }, "{:.0f}", 0);
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

}  // namespace

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

}  // namespace flair::cli
