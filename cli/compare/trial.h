// SPDX-License-Identifier: GPL-3.0-or-later
// Optimizers on the same problems, judged on one scale.
#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/optimizer_service.pb.h"
#include "nlohmann/json.hpp"

namespace flair::cli {

// What one call of the graph came to.
struct Verdict {
  v1::EdgeOutcome outcome;
  // Our catalogue has no such type: the verdict is the optimizer's own.
  bool is_its_own = false;
};

// What one optimizer made of one graph.
struct Trial {
  // With our verdicts, costs and measures in place of its own; edges of types that we do not know keep its.
  v1::SolvedLayout layout;
  v1::Producer producer;
  std::vector<Verdict> verdicts = {};  // one per edge of the graph
  int held_count = 0;
  int claimed_count = 0;  // edges that it says hold
  int unknown_count = 0;  // edges whose type we do not know
  double seconds = 0;     // wall time of the call
};

// Judges an answer: our Evaluate on its placements of `request`'s graph, whatever graph the answer holds. INTERNAL says
// what of the answer cannot be used.
absl::StatusOr<Trial> Judge(const v1::SolveRequest& request, const v1::SolveResponse& response);

// Asks the optimizer at `address`, or one in this process when it is empty, and judges its answer. Errors as CallSolve
// and Judge.
absl::StatusOr<Trial> RunTrial(const v1::SolveRequest& request, const std::string& address);

// One figure of a trial, in the order in which they are shown.
struct Figure {
  const char* name;   // such as "OOB %"
  const char* field;  // in JSON
  int digits;
  double (*value)(const Trial& trial);
};
const std::vector<Figure>& Figures();

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
