// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/solved_layout.h"

#include <algorithm>
#include <numeric>

#include "evaluation/metrics/layout_metrics.h"
#include "fmt/format.h"
#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/stages/contradictions.h"
#include "optimizer_worker/stages/fit_diagnostics.h"
#include "optimizer_worker/stages/outcomes.h"
#include "optimizer_worker/stages/placements.h"
#include "optimizer_worker/stages/solve_input.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {

namespace {

template <typename Message>
void MoveInto(std::vector<Message> messages, google::protobuf::RepeatedPtrField<Message>& field) {
  for (Message& message : messages) *field.Add() = std::move(message);
}

// Says of each object that was left out on purpose why, instead of that it is not placed.
template <typename Message>
void ExplainLeftOut(const SolveInput& input, const Branch& branch, Message& message) {
  for (const LeftOut& left : branch.left_out) {
    const Object& object = input.scene.objects[left.object];
    for (v1::Diagnostic& diagnostic : *message.mutable_diagnostics()) {
      if (diagnostic.code() != "not_placed" || diagnostic.subject_id() != object.id) continue;
      const bool requested = input.graph.object_list().objects(left.object).requested();
      diagnostic.set_severity(requested ? v1::SEVERITY_ERROR : v1::SEVERITY_WARNING);
      diagnostic.set_code("left_out");
      diagnostic.set_message(fmt::format("\"{}\" ({:.2f} m x {:.2f} m) is left out: {}", object.id,
                                         object.footprint.width_m, object.footprint.depth_m, left.reason));
    }
    for (int e = 0; e < input.graph.edges_size(); ++e) {
      const std::vector<int> named = NamedObjects(input.graph.edges(e), input.scene);
      v1::EdgeOutcome& outcome = *message.mutable_edge_outcomes(e);
      const bool names_it = std::find(named.begin(), named.end(), left.object) != named.end();
      if (!names_it || outcome.status() != v1::OUTCOME_STATUS_DROPPED) continue;
      outcome.set_reason(fmt::format("\"{}\" is left out: {}", object.id, left.reason));
    }
  }
}

// What a layout and a runner-up have in common.
template <typename Message>
void Describe(const SolveInput& input, const SceneCosts& costs, const Branch& branch, Message& message) {
  const PartialLayout& state = branch.state;
  MoveInto(MakePlacements(input, state), *message.mutable_placements());
  MoveInto(MakeZoneRegions(input, state), *message.mutable_zone_regions());
  MoveInto(EdgeOutcomes(input, costs, state), *message.mutable_edge_outcomes());
  MoveInto(FitDiagnostics(input, costs, state), *message.mutable_diagnostics());
  ExplainLeftOut(input, branch, message);
  *message.mutable_metrics() = evaluation::MeasureLayout({input.scene, state.layout, state.placed});
}

v1::RunnerUp MakeRunnerUp(const SolveInput& input, const Branch& branch) {
  v1::RunnerUp runner_up;
  runner_up.set_cost(branch.score);
  if (branch.complete) {
    Describe(input, BindCosts(input, branch.state), branch, runner_up);
  } else {
    MoveInto(MakePlacements(input, branch.state), *runner_up.mutable_placements());
  }
  return runner_up;
}

v1::Diagnostic Note(v1::Severity severity, const char* code, std::string message) {
  v1::Diagnostic diagnostic;
  diagnostic.set_severity(severity);
  diagnostic.set_code(code);
  diagnostic.set_message(std::move(message));
  return diagnostic;
}

}  // namespace

std::vector<v1::Diagnostic> SolveDiagnostics(const SolveInput& input, const std::vector<Branch>& branches) {
  std::vector<v1::Diagnostic> diagnostics;
  const auto& outcomes = branches.front().outcomes;
  const bool stopped =
      std::any_of(outcomes.begin(), outcomes.end(), [](const v1::StageOutcome& o) { return o.stopped_early(); });
  if (stopped) {
    diagnostics.push_back(Note(v1::SEVERITY_NOTE, "time_limit",
                               fmt::format("the time limit of {:.3g} s ended the search: this is the best layout until "
                                           "then; more time may find a better one",
                                           absl::ToDoubleSeconds(input.settings.time_limit))));
  }
  const int wanted = input.settings.variant_count, found = static_cast<int>(branches.size());
  if (found < wanted) {
    diagnostics.push_back(Note(v1::SEVERITY_WARNING, "fewer_variants",
                               fmt::format("{} layouts were asked for and {} found that differ visibly (a primary "
                                           "object 0.5 m away or turned by 30 degrees)",
                                           wanted, found)));
  }
  return diagnostics;
}

v1::SolvedLayout MakeSolvedLayout(const SolveInput& input, const std::vector<Branch>& branches) {
  const Branch& best = branches.front();
  v1::SolvedLayout layout;
  *layout.mutable_graph() = input.graph;
  const SceneCosts costs = BindCosts(input, best.state);
  Describe(input, costs, best, layout);
  MoveInto(TermOutcomes(input, costs, best.state), *layout.mutable_term_outcomes());
  double total = 0;
  for (const v1::EdgeOutcome& outcome : layout.edge_outcomes()) total += outcome.weighted_cost();
  for (const v1::TermOutcome& outcome : layout.term_outcomes()) total += outcome.cost() * outcome.factor();
  layout.set_total_cost(total);
  for (const v1::StageOutcome& outcome : best.outcomes) *layout.add_stage_outcomes() = outcome;
  for (size_t i = 1; i < branches.size(); ++i) *layout.add_runner_ups() = MakeRunnerUp(input, branches[i]);
  if (input.settings.find_contradictions) {
    MoveInto(FindContradictions(input, layout), *layout.mutable_contradictions());
  }
  MoveInto(SolveDiagnostics(input, branches), *layout.mutable_diagnostics());
  return layout;
}

namespace {

constexpr double kMoved_m = 0.5;
constexpr double kTurned_rad = kPi / 6;

}  // namespace

std::vector<int> LeadingObjects(const SolveInput& input) {
  std::vector<int> leading = FreeStage(input, StageKind::kPrimary).objects;
  if (!leading.empty()) return leading;
  leading = FreeStage(input, StageKind::kPolish).objects;
  std::erase_if(leading, [&](int object) { return input.scene.objects[object].role == ObjectRole::kTertiary; });
  return leading;
}

bool DifferVisibly(std::span<const int> objects, const Layout& a, const Layout& b) {
  return std::any_of(objects.begin(), objects.end(), [&](int object) {
    return Distance(Center(a[object]), Center(b[object])) > kMoved_m ||
           AngleBetween(a[object].theta_rad, b[object].theta_rad) > kTurned_rad;
  });
}

std::vector<size_t> BestDistinct(size_t count, size_t most, const std::function<double(size_t)>& score,
                                 const std::function<bool(size_t, size_t)>& differ) {
  std::vector<size_t> order(count);
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return score(a) < score(b); });
  std::vector<size_t> kept;
  for (size_t i : order) {
    if (kept.size() == most) break;
    if (std::all_of(kept.begin(), kept.end(), [&](size_t k) { return differ(i, k); })) kept.push_back(i);
  }
  return kept;
}

}  // namespace flair::optimizer
