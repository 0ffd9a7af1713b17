// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/solve_table.h"

#include "fmt/format.h"
#include "nlohmann/json.hpp"

namespace flair::cli {
namespace {

using nlohmann::ordered_json;

constexpr char kRow[] =
    "{:<26} {:>4} {:>7} {:>5} {:>8} {:>8} {:>8} {:>8} {:>8} {:>7} {:>7} {:>6} {:>6} {:>8} {:>4}/{:<4}\n";

// Mean of a metric over the measures, or over their recorded layouts.
template <typename Metric>
double MeanOf(const std::vector<SolveMeasure>& measures, bool recorded, const Metric& metric) {
  double sum = 0;
  int count = 0;
  for (const SolveMeasure& measure : measures) {
    if (recorded && !measure.recorded) continue;
    sum += metric(recorded ? *measure.recorded : measure.layout.metrics());
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

struct MetricColumn {
  const char* name;
  double (*of)(const v1::LayoutMetrics&);
};

constexpr MetricColumn kMetrics[] = {
    {"oob_percent", [](const v1::LayoutMetrics& m) { return m.oob_percent(); }},
    {"oor_percent", [](const v1::LayoutMetrics& m) { return m.oor_percent(); }},
    {"deepest_overlap_m", [](const v1::LayoutMetrics& m) { return m.deepest_overlap_m(); }},
    {"reachable_floor_share", [](const v1::LayoutMetrics& m) { return m.reachable_floor_share(); }},
    {"reachable_front_share", [](const v1::LayoutMetrics& m) { return m.reachable_front_share(); }},
    {"pathway_cost_m3", [](const v1::LayoutMetrics& m) { return m.pathway_cost_m3(); }},
};

ordered_json MetricsToJson(const v1::LayoutMetrics& metrics) {
  ordered_json json;
  for (const MetricColumn& column : kMetrics) json[column.name] = column.of(metrics);
  return json;
}

std::vector<double> CpuOf(const std::vector<SolveMeasure>& measures) {
  std::vector<double> cpu_s;
  for (const SolveMeasure& measure : measures) cpu_s.push_back(measure.cpu_s);
  return cpu_s;
}

}  // namespace

std::string SolveTableHeader() {
  return fmt::format(fmt::runtime(kRow), "room", "objs", "CPU ms", "runs", "evals", "primary", "second", "polish",
                     "tertiary", "OOB %", "OOR %", "floor", "fronts", "path m3", "held", "missed");
}

std::string SolveTableRow(const SolveMeasure& m) {
  const auto cost = [&m](const char* stage) { return fmt::format("{:.3f}", m.CostOf(stage)); };
  const v1::LayoutMetrics& metrics = m.layout.metrics();
  return fmt::format(
      fmt::runtime(kRow), m.name.substr(0, 26), m.object_count(), fmt::format("{:.0f}", 1e3 * m.cpu_s),
      m.restart_count(), fmt::format("{:.2f}M", 1e-6 * static_cast<double>(m.evaluation_count())), cost("primary"),
      cost("secondary"), cost("polish"), cost("tertiary"), fmt::format("{:.3f}", metrics.oob_percent()),
      fmt::format("{:.3f}", metrics.oor_percent()), fmt::format("{:.3f}", metrics.reachable_floor_share()),
      fmt::format("{:.3f}", metrics.reachable_front_share()), fmt::format("{:.4f}", metrics.pathway_cost_m3()),
      m.CountOf(v1::OUTCOME_STATUS_SATISFIED), m.CountOf(v1::OUTCOME_STATUS_VIOLATED));
}

std::string SolveTableSummary(const std::vector<SolveMeasure>& measures) {
  int held = 0, missed = 0;
  for (const SolveMeasure& m : measures) {
    held += m.CountOf(v1::OUTCOME_STATUS_SATISFIED);
    missed += m.CountOf(v1::OUTCOME_STATUS_VIOLATED);
  }
  const std::vector<double> cpu_s = CpuOf(measures);
  std::string text = fmt::format(
      "\n{} rooms: CPU median {:.0f} ms, 95th percentile {:.0f} ms; {} of {} constraints hold ({:.1f} %); "
      "peak memory {:.0f} MiB\n",
      measures.size(), 1e3 * Quantile(cpu_s, 0.5), 1e3 * Quantile(cpu_s, 0.95), held, held + missed,
      100.0 * held / std::max(1, held + missed), PeakMemory_MiB());
  text += fmt::format("{:<24} {:>10} {:>10}\n", "mean over rooms", "ours", "recorded");
  for (const MetricColumn& column : kMetrics) {
    text += fmt::format("{:<24} {:>10.4f} {:>10.4f}\n", column.name, MeanOf(measures, false, column.of),
                        MeanOf(measures, true, column.of));
  }
  return text;
}

std::string SolveMeasuresToJson(const std::vector<SolveMeasure>& measures) {
  ordered_json rooms = ordered_json::array();
  for (const SolveMeasure& m : measures) {
    ordered_json room{{"name", m.name},
                      {"objects", m.object_count()},
                      {"cpu_s", m.cpu_s},
                      {"wall_s", m.wall_s},
                      {"restarts", m.restart_count()},
                      {"evaluations", m.evaluation_count()},
                      {"total_cost", m.layout.total_cost()},
                      {"satisfied", m.CountOf(v1::OUTCOME_STATUS_SATISFIED)},
                      {"violated", m.CountOf(v1::OUTCOME_STATUS_VIOLATED)},
                      {"dropped", m.CountOf(v1::OUTCOME_STATUS_DROPPED)}};
    for (const char* stage : {"primary", "secondary", "polish", "tertiary"}) room["cost"][stage] = m.CostOf(stage);
    room["metrics"] = MetricsToJson(m.layout.metrics());
    if (m.recorded) room["recorded_metrics"] = MetricsToJson(*m.recorded);
    rooms.push_back(std::move(room));
  }
  ordered_json summary{{"cpu_median_s", Quantile(CpuOf(measures), 0.5)},
                       {"cpu_p95_s", Quantile(CpuOf(measures), 0.95)},
                       {"peak_memory_mib", PeakMemory_MiB()}};
  for (const MetricColumn& column : kMetrics) {
    summary["ours"][column.name] = MeanOf(measures, false, column.of);
    summary["recorded"][column.name] = MeanOf(measures, true, column.of);
  }
  return ordered_json{{"rooms", rooms}, {"summary", summary}}.dump(1) + "\n";
}

}  // namespace flair::cli
