// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/outcomes.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "fmt/format.h"
#include "optimizer_worker/constraints/shortfall.h"
#include "optimizer_worker/zones/voronoi_zones.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {
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
      outcome.set_reason(fmt::format("object \"{}\" is not placed", input.scene.objects[missing].id));
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

}  // namespace flair::optimizer
