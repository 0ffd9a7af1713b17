// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of solves, for programs.
#pragma once

#include <string>
#include <vector>

#include "cli/bench/solve_measure.h"

namespace flair::cli {

// A file that could not be measured.
struct BenchFailure {
  std::string file;
  std::string reason;
};

// {"rooms": [...], "failures": [...], "summary": {...}}, indented, ending in a newline.
std::string SolveMeasuresToJson(const std::vector<SolveMeasure>& measures, const std::vector<BenchFailure>& failures,
                                double memory_before_MiB);

}  // namespace flair::cli
