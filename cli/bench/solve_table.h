// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of solves, for people.
#pragma once

#include <string>
#include <vector>

#include "cli/bench/solve_measure.h"
#include "cli/output/text_table.h"

namespace flair::cli {

// One of the measures of a layout: its name in LayoutMetrics, and what people read.
struct MetricColumn {
  const char* name;
  const char* title;
  double (*of)(const v1::LayoutMetrics&);
  // Which end is good.
  bool less_is_better;
};

inline constexpr MetricColumn kMetrics[] = {
    {"oob_percent", "OOB, % of the room", [](const v1::LayoutMetrics& m) { return m.oob_percent(); }, true},
    {"oor_percent", "OOR, % of the room", [](const v1::LayoutMetrics& m) { return m.oor_percent(); }, true},
    {"deepest_overlap_m", "deepest overlap, m", [](const v1::LayoutMetrics& m) { return m.deepest_overlap_m(); }, true},
    {"reachable_floor_share", "reachable floor, share",
     [](const v1::LayoutMetrics& m) { return m.reachable_floor_share(); }, false},
    {"reachable_front_share", "reachable fronts, share",
     [](const v1::LayoutMetrics& m) { return m.reachable_front_share(); }, false},
    {"pathway_cost_m3", "pathway cost, m3", [](const v1::LayoutMetrics& m) { return m.pathway_cost_m3(); }, true},
};

// What the columns of SolveTable mean, a line each; ends in an empty line.
std::string SolveLegend();

// One line a room; `name_width` is that of the longest name.
TextTable SolveTable(size_t name_width);
std::vector<std::string> SolveCells(const SolveMeasure& measure);

// Medians and means over all rooms, the rooms that are worst by each measure, and, beside those of the recorded
// layouts, the measures over the rooms that have one. `memory_before_MiB` is what the process held before the first
// solve.
std::string SolveSummary(const std::vector<SolveMeasure>& measures, double memory_before_MiB);

}  // namespace flair::cli
