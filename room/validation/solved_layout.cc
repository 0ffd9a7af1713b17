// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "room/validation/checks.h"

namespace flair::validation {
namespace {

// Objects may end outside the room when they do not fit, but not at the end of the world.
constexpr Range kHeading{.least = 0, .most = 6.283185307179587, .open_most = true};
constexpr Range kCost{.least = 0, .most = 1e300};

void CheckRegions(const v1::SolvedLayout& layout, const Known& known, const Field& at) {
  for (int i = 0; i < layout.zone_regions_size(); ++i) {
    const v1::ZoneRegion& region = layout.zone_regions(i);
    at[i]["zone_id"].Refers(region.zone_id(), *known.zones, "a zone");
    for (int k = 0; k < region.parts_size(); ++k) {
      for (const v1::Point2& p : region.parts(k).vertices()) {
        at[i]["parts"][k].InRange(p.x_m(), kCoordinate);
        at[i]["parts"][k].InRange(p.y_m(), kCoordinate);
      }
    }
  }
}

}  // namespace

void CheckPlacements(const google::protobuf::RepeatedPtrField<v1::Placement>& placements, const Known& known,
                     const Field& at) {
  NameSet seen;
  for (int i = 0; i < placements.size(); ++i) {
    const v1::Placement& placement = placements[i];
    const Field here = at[i];
    here["object_id"].NewId(placement.object_id(), seen);
    if (known.objects != nullptr) here["object_id"].Refers(placement.object_id(), *known.objects, "an object");
    here["x_m"].InRange(placement.x_m(), kCoordinate);
    here["y_m"].InRange(placement.y_m(), kCoordinate);
    here["z_m"].InRange(placement.z_m(), kCoordinate);
    here["theta_rad"].InRange(placement.theta_rad(), kHeading);
  }
}

void CheckEdgeOutcomes(const google::protobuf::RepeatedPtrField<v1::EdgeOutcome>& outcomes, const Known& known,
                       const Field& at) {
  for (int i = 0; i < outcomes.size(); ++i) {
    const v1::EdgeOutcome& outcome = outcomes[i];
    const Field here = at[i];
    if (known.edges != nullptr) here["edge_id"].Refers(outcome.edge_id(), *known.edges, "an edge");
    here["cost"].InRange(outcome.cost(), kCost);
    here["weighted_cost"].InRange(outcome.weighted_cost(), kCost);
    here["status"].Enum(outcome.status(), v1::OutcomeStatus_IsValid(outcome.status()));
  }
}

void Check(const v1::SolvedLayout& layout, const Field& at) {
  Check(layout.graph(), at["graph"]);
  const NameSet zones = ZoneIds(layout.graph().zone_plan());
  const NameSet objects = ObjectIds(layout.graph().object_list());
  const NameSet edges = EdgeIds(layout.graph());
  const Known known{.zones = &zones, .objects = &objects, .edges = &edges};
  CheckPlacements(layout.placements(), known, at["placements"]);
  CheckRegions(layout, known, at["zone_regions"]);
  CheckEdgeOutcomes(layout.edge_outcomes(), known, at["edge_outcomes"]);
  for (int i = 0; i < layout.runner_ups_size(); ++i) {
    const v1::RunnerUp& runner_up = layout.runner_ups(i);
    const Field field = at["runner_ups"][i];
    CheckPlacements(runner_up.placements(), known, field["placements"]);
    CheckEdgeOutcomes(runner_up.edge_outcomes(), known, field["edge_outcomes"]);
    CheckDiagnostics(runner_up.diagnostics(), field["diagnostics"]);
  }
  for (int i = 0; i < layout.contradictions_size(); ++i) {
    const Field field = at["contradictions"][i];
    field["edge_ids"].Count(layout.contradictions(i).edge_ids_size(), 1, 20000, "edges");
    for (int k = 0; k < layout.contradictions(i).edge_ids_size(); ++k) {
      field["edge_ids"][k].Refers(layout.contradictions(i).edge_ids(k), edges, "an edge");
    }
  }
  CheckDiagnostics(layout.diagnostics(), at["diagnostics"]);
  if (!std::isfinite(layout.total_cost())) at["total_cost"].Reject("{} is no number", layout.total_cost());
}

}  // namespace flair::validation
