// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/layouts/comparing.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "optimizer_worker/solver/separation.h"
#include "room/conversion/conversion.h"

namespace flair::session {
namespace {

// What stands this near to a piece may be what it needs the room of.
constexpr double kReach_m = 1.0;
// As for a resolve: nothing moves for a gain of less.
constexpr double kWorthMoving = 0.05;
// What a way through the room is worth against sentences: a tenth of the floor as much as one of weight 1.
constexpr double kWayWeight = 10;

double FaultsOf(const v1::SolvedLayout& layout) {
  const auto& findings = layout.metrics().findings();
  const auto faults = std::ranges::count_if(
      findings, [](const v1::Finding& one) { return one.kind() != v1::FINDING_KIND_USE_NOT_MET; });
  return static_cast<double>(faults + layout.graph().object_list().objects_size() - layout.placements_size());
}

double MissedBy(const v1::SolvedLayout& layout, const v1::SolvedLayout& before) {
  double missed = 0;
  ForOutcomes(layout, [&](const v1::ConstraintEdge& edge, const v1::EdgeOutcome& outcome) {
    if (outcome.status() != v1::OUTCOME_STATUS_SATISFIED) missed += edge.weight();
  });
  for (const v1::Finding& one : layout.metrics().findings()) missed += one.kind() == v1::FINDING_KIND_USE_NOT_MET;
  const double lost = before.metrics().reachable_floor_share() - layout.metrics().reachable_floor_share();
  return missed + kWayWeight * std::max(0.0, lost);
}

}  // namespace

IdSet InReach(const v1::SolvedLayout& layout, const IdSet& ids) {
  IdSet reached = ids;
  for (const v1::ConstraintEdge& edge : layout.graph().edges()) {
    IdSet named = ObjectsOf(edge, layout.graph());
    if (std::ranges::any_of(named, [&](const std::string& id) { return ids.contains(id); })) reached.merge(named);
  }
  const absl::StatusOr<Scene> scene = SceneFromProto(layout.graph());
  if (!scene.ok()) return reached;
  std::map<std::string, Box<double>> boxes;
  for (const v1::Placement& at : layout.placements()) {
    const int index = scene->IndexOf(at.object_id());
    if (index < 0 || !IsSolid(scene->objects[index])) continue;
    const Pose<double> pose{at.x_m(), at.y_m(), at.theta_rad()};
    boxes.emplace(at.object_id(), Box<double>(scene->objects[index].footprint, FrameOf(pose)));
  }
  for (const auto& [id, box] : boxes) {
    for (const std::string& one : ids) {
      const auto other = boxes.find(one);
      if (other != boxes.end() && optimizer::Separate(box, other->second).gap_m < kReach_m) reached.insert(id);
    }
  }
  for (bool more = true; more;) {
    more = false;
    for (const v1::Object& object : layout.graph().object_list().objects()) {
      more = (reached.contains(object.host_id()) && reached.insert(object.id()).second) || more;
    }
  }
  return reached;
}

bool IsBetter(const v1::SolvedLayout& a, const v1::SolvedLayout& b, const v1::SolvedLayout& before) {
  constexpr double kRounding = 1e-6;
  if (FaultsOf(a) != FaultsOf(b)) return FaultsOf(a) < FaultsOf(b);
  const double gain = MissedBy(b, before) - MissedBy(a, before);
  if (std::abs(gain) > kRounding) return gain > 0;
  return a.total_cost() < b.total_cost() - kWorthMoving;
}

v1::SolvedLayout Flawless() {
  v1::SolvedLayout flawless;
  flawless.mutable_metrics()->set_reachable_floor_share(1);
  return flawless;
}

bool HoldsMore(const v1::SolvedLayout& a, const v1::SolvedLayout& b, const v1::SolvedLayout& before) {
  constexpr double kSeen = 1e-3;
  if (FaultsOf(a) != FaultsOf(b)) return FaultsOf(a) < FaultsOf(b);
  return MissedBy(a, before) < MissedBy(b, before) - kSeen;
}

bool HasMoreFaults(const v1::SolvedLayout& layout, const v1::SolvedLayout& before) {
  return FaultsOf(layout) > FaultsOf(before);
}

bool IsWorseOff(const v1::SolvedLayout& layout, const v1::SolvedLayout& before) {
  constexpr double kClearly = 0.03;
  const double lost = before.metrics().reachable_floor_share() - layout.metrics().reachable_floor_share();
  return HasMoreFaults(layout, before) || lost > kClearly;
}

}  // namespace flair::session
