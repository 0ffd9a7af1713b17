// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of solves, for people and for programs.
#pragma once

#include <string>
#include <vector>

#include "cli/bench/solve_measure.h"

namespace flair::cli {

// Lines of one table, each ending in a newline.
std::string SolveTableHeader();
std::string SolveTableRow(const SolveMeasure& measure);
// Medians and means over all rows, beside those of the recorded layouts.
std::string SolveTableSummary(const std::vector<SolveMeasure>& measures);

// {"rooms": [...], "summary": {...}}, indented, ending in a newline.
std::string SolveMeasuresToJson(const std::vector<SolveMeasure>& measures);

}  // namespace flair::cli
