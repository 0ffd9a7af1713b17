// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/solve_text.h"

#include <algorithm>
#include <vector>

#include "cli/output/text.h"
#include "fmt/format.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {

namespace {

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
