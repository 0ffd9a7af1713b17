// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/compare/trial.h"

#include <algorithm>
#include <map>
#include <set>

#include "absl/time/clock.h"
#include "cli/session/stage_calls.h"
#include "fmt/format.h"
#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "room/validation/validate.h"

namespace flair::cli {
namespace {

std::set<std::string> OwnTypes() {
  std::set<std::string> names;
  for (const v1::ConstraintType& type : optimizer::MakeCatalog().types()) {
    names.insert(type.name());
    names.insert(type.aliases().begin(), type.aliases().end());
  }
  return names;
}

double TotalCost(const v1::SolvedLayout& layout) {
  double total = 0;
  for (const v1::EdgeOutcome& edge : layout.edge_outcomes()) total += edge.weighted_cost();
  for (const v1::TermOutcome& term : layout.term_outcomes()) total += term.cost() * term.factor();
  return total;
}

// What the optimizer says of an edge, by id.
std::map<std::string, v1::EdgeOutcome> ClaimsOf(const v1::SolvedLayout& layout) {
  std::map<std::string, v1::EdgeOutcome> claims;
  for (const v1::EdgeOutcome& outcome : layout.edge_outcomes()) claims[outcome.edge_id()] = outcome;
  return claims;
}

void FillVerdicts(const v1::LayoutGraph& graph, const v1::SolvedLayout& answer, Trial& trial) {
  static const std::set<std::string> own_types = OwnTypes();
  const std::map<std::string, v1::EdgeOutcome> claims = ClaimsOf(answer);
  for (int i = 0; i < graph.edges_size(); ++i) {
    const v1::ConstraintEdge& edge = graph.edges(i);
    Verdict verdict{.outcome = trial.layout.edge_outcomes(i), .is_its_own = !own_types.contains(edge.type())};
    const auto claim = claims.find(edge.id());
    if (claim != claims.end()) {
      trial.claimed_count += claim->second.status() == v1::OUTCOME_STATUS_SATISFIED ? 1 : 0;
      if (verdict.is_its_own) verdict.outcome = claim->second;
    }
    trial.unknown_count += verdict.is_its_own ? 1 : 0;
    trial.held_count += verdict.outcome.status() == v1::OUTCOME_STATUS_SATISFIED ? 1 : 0;
    *trial.layout.mutable_edge_outcomes(i) = verdict.outcome;
    trial.verdicts.push_back(std::move(verdict));
  }
}

}  // namespace

absl::StatusOr<Trial> Judge(const v1::SolveRequest& request, const v1::SolveResponse& response) {
  if (absl::Status status = Validate(response.solved_layout()); !status.ok()) {
    return absl::InternalError(fmt::format("its layout is not valid: {}", std::string(status.message())));
  }
  v1::EvaluateRequest evaluate;
  *evaluate.mutable_layout_graph() = request.layout_graph();
  *evaluate.mutable_placements() = response.solved_layout().placements();
  *evaluate.mutable_options() = request.options();
  const optimizer::NloptSolver solver;
  const absl::StatusOr<v1::EvaluateResponse> judged = optimizer::EvaluateLayout(evaluate, solver);
  if (!judged.ok()) {
    return absl::InternalError(fmt::format("its layout cannot be judged: {}", std::string(judged.status().message())));
  }
  Trial trial{.layout = response.solved_layout(), .producer = response.producer()};
  *trial.layout.mutable_graph() = request.layout_graph();
  *trial.layout.mutable_edge_outcomes() = judged->edge_outcomes();
  *trial.layout.mutable_term_outcomes() = judged->term_outcomes();
  *trial.layout.mutable_metrics() = judged->metrics();
  FillVerdicts(request.layout_graph(), response.solved_layout(), trial);
  trial.layout.set_total_cost(TotalCost(trial.layout));
  return trial;
}

absl::StatusOr<Trial> RunTrial(const v1::SolveRequest& request, const std::string& address) {
  const absl::Time start = absl::Now();
  const absl::StatusOr<v1::SolveResponse> response = CallSolve(request, address);
  const double seconds = absl::ToDoubleSeconds(absl::Now() - start);
  if (!response.ok()) return response.status();
  absl::StatusOr<Trial> trial = Judge(request, *response);
  if (trial.ok()) trial->seconds = seconds;
  return trial;
}

const std::vector<Figure>& Figures() {
  static const std::vector<Figure> figures = {
      {"constraints that hold, %", "satisfied_percent", 1,
       [](const Trial& trial) {
         return trial.verdicts.empty() ? 100.0 : 100.0 * trial.held_count / static_cast<double>(trial.verdicts.size());
       }},
      {"out of bounds (OOB), %", "oob_percent", 3,
       [](const Trial& trial) { return trial.layout.metrics().oob_percent(); }},
      {"overlaps (OOR), %", "oor_percent", 3, [](const Trial& trial) { return trial.layout.metrics().oor_percent(); }},
      {"deepest overlap, mm", "deepest_overlap_mm", 1,
       [](const Trial& trial) { return 1e3 * trial.layout.metrics().deepest_overlap_m(); }},
      {"floor reached, %", "reachable_floor_percent", 1,
       [](const Trial& trial) { return 100 * trial.layout.metrics().reachable_floor_share(); }},
      {"fronts reached, %", "reachable_front_percent", 1,
       [](const Trial& trial) { return 100 * trial.layout.metrics().reachable_front_share(); }},
      {"pathway cost, m3", "pathway_cost_m3", 4,
       [](const Trial& trial) { return trial.layout.metrics().pathway_cost_m3(); }},
      {"total cost", "total_cost", 3, [](const Trial& trial) { return trial.layout.total_cost(); }},
      {"seconds", "seconds", 2, [](const Trial& trial) { return trial.seconds; }},
  };
  return figures;
}

}  // namespace flair::cli
