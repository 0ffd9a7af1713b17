// SPDX-License-Identifier: GPL-3.0-or-later
// What a replay showed, for people and for programs.
#pragma once

#include <string>
#include <vector>

#include "cli/replay/comparison.h"

namespace flair::cli {

// A line or two per stage, ending in newlines.
std::string ComparisonTable(const std::vector<StageComparison>& stages);

// One line: what agrees, where the jobs part first, and the likely cause.
std::string ComparisonSummary(const std::vector<StageComparison>& stages);

// One JSON object on one line, without the newline: both ids, "agrees", and the stages.
std::string ComparisonJson(const std::vector<StageComparison>& stages, const std::string& first_id,
                           const std::string& replay_id);

}  // namespace flair::cli
