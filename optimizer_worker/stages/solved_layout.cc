// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/solved_layout.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "evaluation/metrics/layout_metrics.h"
#include "evaluation/metrics/measures.h"
#include "fmt/format.h"
#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/constraints/shortfall.h"
#include "optimizer_worker/stages/infeasible.h"
#include "optimizer_worker/stages/tertiary.h"
#include "optimizer_worker/zones/voronoi_zones.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {

std::vector<v1::Placement> MakePlacements(const SolveInput& input, const PartialLayout& state) {
  std::vector<v1::Placement> placements;
  for (int i = 0; i < static_cast<int>(input.scene.objects.size()); ++i) {
    if (!state.placed[i]) continue;
    v1::Placement& placement = placements.emplace_back();
    placement.set_object_id(input.scene.objects[i].id);
    placement.set_x_m(state.layout[i].x_m + 0.0);
    placement.set_y_m(state.layout[i].y_m + 0.0);
    placement.set_z_m(UndersideOf(input.scene, i, state.layout, state.placed));
    placement.set_theta_rad(WrapHeading(state.layout[i].theta_rad));
  }
  return placements;
}

absl::Status ReadPlacements(const SolveInput& input,
                            const google::protobuf::RepeatedPtrField<v1::Placement>& placements, PartialLayout& state) {
  for (int i = 0; i < placements.size(); ++i) {
    const v1::Placement& placement = placements[i];
    const int object = input.scene.IndexOf(placement.object_id());
    if (object < 0) {
      return absl::InvalidArgumentError(
          fmt::format("placements[{}].object_id: \"{}\" is not an object of the graph", i, placement.object_id()));
    }
    if (!std::isfinite(placement.x_m()) || !std::isfinite(placement.y_m()) || !std::isfinite(placement.theta_rad())) {
      return absl::InvalidArgumentError(
          fmt::format("placements[{}]: the pose of \"{}\" is not finite", i, placement.object_id()));
    }
    state.Place(object, {placement.x_m(), placement.y_m(), placement.theta_rad()});
  }
  return absl::OkStatus();
}

namespace {

double CostOf(const Term& term, const Layout& layout) {
  std::vector<Pose<double>> poses;
  for (int object : term.cost->objects()) poses.push_back(layout[object]);
  // One minus a product of unit vectors may round to just below 0; no cost of a layout is negative.
  return std::max(0.0, term.cost->Value(poses));
}

// The first object that the term needs and that has no pose; -1 when all have one.
int MissingObject(const Term& term, const PartialLayout& state) {
  for (int object : term.required) {
    if (!state.placed[object]) return object;
  }
  return -1;
}

// Why an edge of this cost does not hold: what is missed by most, or at least how much its cost is.
void SayWhy(const v1::ConstraintEdge& edge, const Furnished& where, v1::EdgeOutcome& outcome) {
  const std::optional<Shortfall> shortfall = Explain(edge, where);
  if (!shortfall) {
    outcome.set_reason(fmt::format("\"{}\" is not met: its cost is {:.3g}, {} would be met", edge.type(),
                                   outcome.cost(), kSatisfiedCost));
    return;
  }
  outcome.set_reason(shortfall->sentence);
  outcome.set_missed_by(shortfall->missed_by);
  outcome.set_unit(shortfall->unit);
}

}  // namespace

std::vector<v1::EdgeOutcome> EdgeOutcomes(const SolveInput& input, const SceneCosts& costs,
                                          const PartialLayout& state) {
  std::vector<v1::EdgeOutcome> outcomes(input.graph.edges_size());
  for (int e = 0; e < input.graph.edges_size(); ++e) {
    outcomes[e].set_edge_id(input.graph.edges(e).id());
    outcomes[e].set_status(v1::OUTCOME_STATUS_DROPPED);
    outcomes[e].set_reason(costs.dropped[e]);
  }
  const std::vector<Vec2<double>> centers = ZoneCenters(input.scene, state.placed, state.layout);
  const Furnished where{input.scene, state.layout, centers, &input.linked};
  for (const Term& term : costs.terms) {
    if (term.edge < 0) continue;
    v1::EdgeOutcome& outcome = outcomes[term.edge];
    const int missing = MissingObject(term, state);
    if (missing >= 0) {
      outcome.set_reason(NameForPeople(input.scene, missing) + " is not placed");
      continue;
    }
    const double cost = CostOf(term, state.layout);
    const bool satisfied = cost <= kSatisfiedCost;
    outcome.set_cost(cost);
    outcome.set_weighted_cost(cost * term.factor);
    outcome.set_status(satisfied ? v1::OUTCOME_STATUS_SATISFIED : v1::OUTCOME_STATUS_VIOLATED);
    if (!satisfied) SayWhy(input.graph.edges(term.edge), where, outcome);
  }
  return outcomes;
}

std::vector<v1::TermOutcome> TermOutcomes(const SolveInput& input, const SceneCosts& costs,
                                          const PartialLayout& state) {
  std::map<std::string, v1::TermOutcome> by_name;
  for (const Term& term : costs.terms) {
    if (term.edge >= 0 || MissingObject(term, state) >= 0) continue;
    v1::TermOutcome& outcome = by_name[term.name];
    outcome.set_term(term.name);
    outcome.set_cost(outcome.cost() + CostOf(term, state.layout));
    outcome.set_factor(term.factor);
  }
  std::vector<v1::TermOutcome> outcomes;
  for (auto& [name, outcome] : by_name) outcomes.push_back(std::move(outcome));
  return outcomes;
}

std::vector<v1::ZoneRegion> MakeZoneRegions(const SolveInput& input, const PartialLayout& state) {
  const std::vector<Vec2<double>> centers = ZoneCenters(input.scene, state.placed, state.layout);
  const std::vector<ZoneCell> cells = VoronoiZones(input.scene.room.floor, centers);
  std::vector<v1::ZoneRegion> regions;
  for (size_t z = 0; z < centers.size(); ++z) {
    if (centers[z].x >= kEmptyZone_m) continue;
    v1::ZoneRegion& region = regions.emplace_back();
    region.set_zone_id(input.scene.zones[z].id);
    region.mutable_center()->set_x_m(centers[z].x);
    region.mutable_center()->set_y_m(centers[z].y);
    for (const Polygon& part : cells[z]) {
      v1::Polygon* polygon = region.add_parts();
      for (const Vec2<double>& p : part.vertices) {
        v1::Point2* vertex = polygon->add_vertices();
        // Adding 0 makes -0 a 0: the JSON form knows no difference, and has to keep the bytes.
        vertex->set_x_m(p.x + 0.0);
        vertex->set_y_m(p.y + 0.0);
      }
    }
  }
  return regions;
}

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
    const std::string name = NameForPeople(input.scene, left.object);
    for (v1::Diagnostic& diagnostic : *message.mutable_diagnostics()) {
      if (diagnostic.code() != "not_placed" || diagnostic.subject_id() != object.id) continue;
      const v1::Object& listed = input.graph.object_list().objects(left.object);
      diagnostic.set_severity(listed.requested() ? v1::SEVERITY_ERROR
                              : listed.spare()   ? v1::SEVERITY_NOTE
                                                 : v1::SEVERITY_WARNING);
      diagnostic.set_code("left_out");
      diagnostic.set_message(fmt::format("{} ({:.2f} m x {:.2f} m) is left out: {}", name, object.footprint.width_m,
                                         object.footprint.depth_m, left.reason));
    }
    for (int e = 0; e < input.graph.edges_size(); ++e) {
      const std::vector<int> named = NamedObjects(input.graph.edges(e), input.scene);
      v1::EdgeOutcome& outcome = *message.mutable_edge_outcomes(e);
      const bool names_it = std::find(named.begin(), named.end(), left.object) != named.end();
      if (!names_it || outcome.status() != v1::OUTCOME_STATUS_DROPPED) continue;
      outcome.set_reason(fmt::format("{} is left out: {}", name, left.reason));
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
  evaluation::AddUses(input.graph, message.placements(), message.edge_outcomes(), *message.mutable_metrics());
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
  const bool stopped = std::ranges::any_of(outcomes, [](const v1::StageOutcome& o) { return o.stopped_early(); });
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

}  // namespace flair::optimizer
