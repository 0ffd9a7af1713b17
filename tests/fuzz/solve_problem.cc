// SPDX-License-Identifier: GPL-3.0-or-later
// The solver's entry on small problems. What must hold of every result:
//   a refusal is INVALID_ARGUMENT with a reason, and comes exactly when graph or options do not validate;
//   every number is finite, and the layout passes its own validation;
//   every object is placed or named in the diagnostics;
//   what overlaps or lies out of the room according to the metrics is named in the diagnostics.
#include <cmath>
#include <set>
#include <string>

#include "fmt/format.h"
#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "room/validation/validate.h"
#include "tests/fuzz/random_problem.h"
#include "tests/fuzz/targets.h"

namespace flair::fuzz {
namespace {

// What the metrics may see of shapes that touch: rounding over some metres.
constexpr double kTouching_m = 2e-6;
constexpr double kTouching_percent = 1e-3;

void CheckFinite(const v1::LayoutMetrics& metrics) {
  for (double value : {metrics.oob_percent(), metrics.oor_percent(), metrics.reachable_floor_share(),
                       metrics.reachable_front_share(), metrics.pathway_cost_m3(), metrics.deepest_overlap_m()}) {
    Require(std::isfinite(value) && value >= 0, "metrics are finite and not negative");
  }
}

void CheckNamed(const v1::SolvedLayout& layout) {
  std::set<std::string> named;
  std::set<std::string> placed;
  for (const v1::Diagnostic& diagnostic : layout.diagnostics()) named.insert(diagnostic.subject_id());
  for (const v1::Placement& placement : layout.placements()) placed.insert(placement.object_id());
  for (const v1::Object& object : layout.graph().object_list().objects()) {
    Require(placed.contains(object.id()) || named.contains(object.id()), "every object is placed or said why not");
  }
  const v1::LayoutMetrics& metrics = layout.metrics();
  const bool exact = metrics.deepest_overlap_m() <= kTouching_m && metrics.oob_percent() <= kTouching_percent &&
                     metrics.oor_percent() <= kTouching_percent;
  Require(exact || !layout.diagnostics().empty(),
          fmt::format("what does not fit is named: {}", metrics.ShortDebugString()));
}

void CheckLayout(const v1::LayoutGraph& graph, const v1::SolvedLayout& layout) {
  Require(Validate(layout).ok(), "a solved layout is valid");
  Require(layout.edge_outcomes_size() == graph.edges_size(), "every edge has its outcome");
  for (const v1::EdgeOutcome& outcome : layout.edge_outcomes()) {
    Require(std::isfinite(outcome.missed_by()), "what an edge misses by is finite");
    Require(outcome.status() != v1::OUTCOME_STATUS_DROPPED || !outcome.reason().empty(), "a dropped edge says why");
  }
  CheckFinite(layout.metrics());
  CheckNamed(layout);
}

}  // namespace

void SolveProblem(std::string_view bytes) {
  ByteSource source(bytes);
  const v1::LayoutGraph graph = RandomGraph(source);
  const v1::SolveOptions options = RandomOptions(source);
  const bool good = Validate(graph).ok() && Validate(options).ok();
  const optimizer::NloptSolver solver;
  const absl::StatusOr<optimizer::SolveResult> result = optimizer::SolveLayout(graph, options, solver);
  Require(result.ok() == good, "what validates is solved, and nothing else");
  if (!result.ok()) {
    Require(absl::IsInvalidArgument(result.status()) && !result.status().message().empty(), "a refusal says why");
    return;
  }
  CheckLayout(graph, result->layout);
}

}  // namespace flair::fuzz
