// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/compare/trial.h"
#include "nlohmann/json.hpp"

namespace flair::cli {

// What every optimizer made of one graph.
struct Contest {
  std::string name;  // of the graph
  v1::LayoutGraph graph;
  int64_t seed = 0;                // that all were given
  std::vector<Trial> trials = {};  // one per optimizer, in their order
};

// Figures and verdicts side by side. With `all`, also the constraints that hold with every optimizer.
std::string ContestText(const Contest& contest, const std::vector<std::string>& optimizers, bool all);

// One line per graph and optimizer, and the medians of each optimizer.
std::string ContestsTable(const std::vector<Contest>& contests, const std::vector<std::string>& optimizers);

nlohmann::json ContestJson(const Contest& contest, const std::vector<std::string>& optimizers);

// "A", "B".
std::string LetterOf(size_t optimizer);

}  // namespace flair::cli
