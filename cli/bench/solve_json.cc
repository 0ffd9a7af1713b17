// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/solve_json.h"

#include "cli/bench/solve_table.h"
#include "cli/bench/statistics.h"
#include "nlohmann/json.hpp"

namespace flair::cli {
namespace {

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
