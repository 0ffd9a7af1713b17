// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/solve_text.h"

#include <algorithm>
#include <vector>

#include "cli/output/text.h"
#include "fmt/format.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {

namespace {

constexpr size_t kNameWidth = 24;

std::string Milliseconds(const google::protobuf::Duration& duration) {
  return fmt::format("{:.1f}", 1e3 * static_cast<double>(duration.seconds()) + 1e-6 * duration.nanos());
}

std::string StageLines(const v1::SolveResponse& response) {
  const v1::SolvedLayout& layout = response.solved_layout();
  const TextTable table({"stage", "restarts", "best one", "evals k", "cost", "wall ms"}, kNameWidth, 9);
  std::string text = table.Header();
  for (int i = 0; i < layout.stage_outcomes_size(); ++i) {
    const v1::StageOutcome& stage = layout.stage_outcomes(i);
    text += table.Row({stage.zone_id().empty() ? stage.stage() : fmt::format("{} {}", stage.stage(), stage.zone_id()),
                       fmt::format("{}", stage.restart_count()), fmt::format("{}", stage.best_restart()),
                       fmt::format("{:.1f}", 1e-3 * static_cast<double>(stage.evaluation_count())),
                       fmt::format("{:.4f}", stage.cost()),
                       i < response.stage_durations_size() ? Milliseconds(response.stage_durations(i)) : "-"});
  }
  return text + "(of the branch that won; the others were furnished beside it)\n";
}

std::string TermLines(const v1::SolvedLayout& layout) {
  const TextTable table({"term of the room", "cost", "factor", "weighted"}, kNameWidth, 9);
  std::string text = table.Header();
  for (const v1::TermOutcome& term : layout.term_outcomes()) {
    text += table.Row({term.term(), fmt::format("{:.4f}", term.cost()), fmt::format("{:g}", term.factor()),
                       fmt::format("{:.4f}", term.cost() * term.factor())});
  }
  double edges = 0;
  for (const v1::EdgeOutcome& edge : layout.edge_outcomes()) edges += edge.weighted_cost();
  text += table.Row({"constraints", "", "", fmt::format("{:.4f}", edges)});
  return text + table.Row({"total", "", "", fmt::format("{:.4f}", layout.total_cost())});
}

std::string MissedLines(const v1::SolvedLayout& layout) {
  std::string text;
  for (int i = 0; i < layout.edge_outcomes_size(); ++i) {
    const v1::EdgeOutcome& edge = layout.edge_outcomes(i);
    if (edge.status() == v1::OUTCOME_STATUS_SATISFIED) continue;
    const std::string type = i < layout.graph().edges_size() ? layout.graph().edges(i).type() : "";
    text += fmt::format("  {:<6} {:<18} {}{}\n", edge.edge_id(), type,
                        edge.status() == v1::OUTCOME_STATUS_DROPPED ? "dropped: " : "", edge.reason());
  }
  return text.empty() ? "all constraints hold\n" : "constraints that do not hold\n" + text;
}

std::string MetricsLine(const v1::LayoutMetrics& m) {
  return fmt::format(
      "out of bounds (OOB)   {:8.4f} % of the room\n"
      "overlaps (OOR)        {:8.4f} % of the room, the deepest {:.3f} mm\n"
      "reachable from a door {:8.1f} % of the free floor, {:.1f} % of the objects' fronts\n"
      "pathway cost          {:8.4f} m3\n",
      m.oob_percent(), m.oor_percent(), 1e3 * m.deepest_overlap_m(), 100 * m.reachable_floor_share(),
      100 * m.reachable_front_share(), m.pathway_cost_m3());
}

template <typename Layout>  // SolvedLayout or RunnerUp
int CountOf(const Layout& layout, v1::OutcomeStatus status) {
  return static_cast<int>(std::count_if(layout.edge_outcomes().begin(), layout.edge_outcomes().end(),
                                        [status](const v1::EdgeOutcome& edge) { return edge.status() == status; }));
}

template <typename Layout>
std::vector<std::string> VariantCells(int number, double cost, const Layout& layout) {
  const v1::LayoutMetrics& m = layout.metrics();
  return {fmt::format("{}", number),
          fmt::format("{:.4f}", cost),
          fmt::format("{}", CountOf(layout, v1::OUTCOME_STATUS_SATISFIED)),
          fmt::format("{}", CountOf(layout, v1::OUTCOME_STATUS_VIOLATED)),
          fmt::format("{:.4f}", m.oob_percent()),
          fmt::format("{:.4f}", m.oor_percent()),
          fmt::format("{:.3f}", m.reachable_floor_share()),
          fmt::format("{:.3f}", m.reachable_front_share()),
          fmt::format("{:.4f}", m.pathway_cost_m3())};
}

// Of the floor objects at the end: what runner-ups are compared by.
double FloorCost(const v1::SolvedLayout& layout) {
  double cost = 0;
  for (const v1::StageOutcome& stage : layout.stage_outcomes()) {
    if (stage.stage() != "tertiary") cost = stage.cost();
  }
  return cost;
}

}  // namespace

std::string LayoutLine(const v1::SolvedLayout& layout) {
  const int count = layout.edge_outcomes_size();
  const std::string held = count == 0 ? ""
                                      : fmt::format("{} of {}, ", CountOf(layout, v1::OUTCOME_STATUS_SATISFIED),
                                                    Counted(count, "constraint holds", "constraints hold"));
  return fmt::format("{}OOB {:.2f} %, OOR {:.2f} %", held, layout.metrics().oob_percent(),
                     layout.metrics().oor_percent());
}

bool IsComplete(const v1::RunnerUp& runner_up) { return runner_up.has_metrics(); }

std::string SolveStats(const v1::SolveResponse& response) {
  const v1::SolvedLayout& layout = response.solved_layout();
  return StageLines(response) + "\n" + TermLines(layout) + "\n" + MissedLines(layout) + "\n" +
         MetricsLine(layout.metrics());
}

std::string VariantsTable(const v1::SolvedLayout& layout, const std::vector<std::string>& files) {
  std::vector<std::string> titles = {"layout", "cost",  "held",   "missed", "OOB %",
                                     "OOR %",  "floor", "fronts", "path m3"};
  if (!files.empty()) titles.push_back("file");
  const TextTable table(titles, 8, 8);
  const auto row = [&](std::vector<std::string> cells, size_t i) {
    if (!files.empty()) cells.push_back(i < files.size() ? files[i] : "");
    return table.Row(cells);
  };
  std::string text = table.Header() + row(VariantCells(1, FloorCost(layout), layout), 0);
  size_t count = 1;
  for (const v1::RunnerUp& runner_up : layout.runner_ups()) {
    if (!IsComplete(runner_up)) continue;
    text += row(VariantCells(static_cast<int>(count) + 1, runner_up.cost(), runner_up), count);
    ++count;
  }
  return text;
}

v1::SolvedLayout VariantOf(const v1::SolvedLayout& layout, int index) {
  const v1::RunnerUp& runner_up = layout.runner_ups(index);
  v1::SolvedLayout variant;
  *variant.mutable_graph() = layout.graph();
  *variant.mutable_placements() = runner_up.placements();
  *variant.mutable_zone_regions() = runner_up.zone_regions();
  *variant.mutable_edge_outcomes() = runner_up.edge_outcomes();
  *variant.mutable_metrics() = runner_up.metrics();
  *variant.mutable_diagnostics() = runner_up.diagnostics();
  return variant;
}

namespace {

constexpr int kListedDrops = 20;

}  // namespace

std::string LayoutRemarks(const v1::SolvedLayout& layout) {
  std::string text;
  for (const v1::Diagnostic& diagnostic : layout.diagnostics()) {
    text += fmt::format("{:<11}{}\n", "remark", diagnostic.message());
  }
  int dropped = 0;
  for (const v1::EdgeOutcome& outcome : layout.edge_outcomes()) {
    if (outcome.status() != v1::OUTCOME_STATUS_DROPPED || ++dropped > kListedDrops) continue;
    text += fmt::format("{:<11}{}: {}\n", "dropped", outcome.edge_id(), outcome.reason());
  }
  if (dropped > kListedDrops) text += fmt::format("{:<11}{} more\n", "dropped", dropped - kListedDrops);
  for (const v1::Contradiction& contradiction : layout.contradictions()) {
    text += fmt::format("{:<11}{}\n", "clash", contradiction.explanation());
  }
  return text;
}

}  // namespace flair::cli
