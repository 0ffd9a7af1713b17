// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/layouts/following.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include "evaluation/metrics/measures.h"
#include "room/conversion/conversion.h"
#include "room/geometry/polygon.h"
#include "room/geometry/pose.h"

namespace flair::session {
namespace {

// By a piece that follows the one that it follows.
using Leaders = std::map<std::string, std::string>;

// What is drawn up to something stands within this of it.
constexpr double kDrawnUp_m = 0.15;

// How far apart two footprints are, taken as discs in the direction from one to the other: exact enough to tell a chair
// at its table from one across the room.
double GapBetween(const v1::Object& a, const v1::Placement& at_a, const v1::Object& b, const v1::Placement& at_b) {
  const double dx = at_b.x_m() - at_a.x_m(), dy = at_b.y_m() - at_a.y_m();
  const auto reach = [dx, dy](const v1::Object& object, double theta_rad) {
    const double across = std::abs(dx * std::cos(theta_rad) + dy * std::sin(theta_rad));
    const double ahead = std::abs(dy * std::cos(theta_rad) - dx * std::sin(theta_rad));
    const double distance = std::hypot(dx, dy);
    if (distance < 1e-9) return std::max(object.width_m(), object.depth_m()) / 2;
    // From the middle to where the line leaves the footprint.
    const double by_width = across > 1e-9 ? object.width_m() / 2 / across : INFINITY;
    const double by_depth = ahead > 1e-9 ? object.depth_m() / 2 / ahead : INFINITY;
    return distance * std::min(by_width, by_depth);
  };
  return std::hypot(dx, dy) - reach(a, at_a.theta_rad()) - reach(b, at_b.theta_rad());
}

// Which pieces are used at another one and stand at it, and at which: sentences of use say so, such as that chairs are
// drawn up to their table. Only smaller pieces follow larger ones, and locked ones follow nobody.
Leaders DrawnUp(const v1::SolvedLayout& layout, const PlacesById& now) {
  std::map<std::string, const v1::Object*> floor;
  for (const v1::Object& object : layout.graph().object_list().objects()) {
    if (object.kind() == v1::OBJECT_KIND_FLOOR && !object.walk_over()) floor[object.id()] = &object;
  }
  const IdSet locked = IdsOf(layout.graph().pinned_placements()), uses = UsesOf(layout.graph());
  const auto area = [](const v1::Object& object) { return object.width_m() * object.depth_m(); };
  Leaders leaders;
  const auto pair = [&](const std::string& one, const std::string& other) {
    const auto a = floor.find(one), b = floor.find(other);
    if (a == floor.end() || b == floor.end() || one == other || !now.contains(one) || !now.contains(other)) return;
    const auto& [small, large] = area(*a->second) < area(*b->second) ? std::pair(a, b) : std::pair(b, a);
    if (locked.contains(small->first) || area(*small->second) >= area(*large->second)) return;
    if (GapBetween(*small->second, now.at(small->first), *large->second, now.at(large->first)) > kDrawnUp_m) return;
    leaders.emplace(small->first, large->first);
  };
  for (const v1::ConstraintEdge& edge : layout.graph().edges()) {
    if (!uses.contains(edge.sentence_id())) continue;
    const std::vector<std::string> named = TextsOf(edge);
    for (const std::string& one : named) {
      for (const std::string& other : named) pair(one, other);
    }
  }
  return leaders;
}

// Wall pieces by the piece above which a sentence hangs them; locked ones follow nobody.
Leaders HungAbove(const v1::SolvedLayout& layout) {
  const IdSet locked = IdsOf(layout.graph().pinned_placements());
  IdSet walls;
  for (const v1::Object& object : layout.graph().object_list().objects()) {
    if (object.kind() == v1::OBJECT_KIND_WALL) walls.insert(object.id());
  }
  Leaders leaders;
  for (const v1::ConstraintEdge& edge : layout.graph().edges()) {
    if (edge.type() != "on_wall_above") continue;
    std::string piece, target;
    for (const v1::Argument& argument : edge.arguments()) {
      if (argument.name() == "object") piece = argument.value().text();
      if (argument.name() == "target") target = argument.value().text();
    }
    if (walls.contains(piece) && !locked.contains(piece) && !target.empty()) leaders.emplace(piece, target);
  }
  return leaders;
}

// Rugs by the piece that lies on most of them, of those that stand on it; locked ones follow nobody.
Leaders LainUnder(const v1::SolvedLayout& layout, const PlacesById& now) {
  // A chair's leg on its fringe is no reason.
  constexpr double kLeastShare = 0.15;
  const IdSet locked = IdsOf(layout.graph().pinned_placements());
  const auto corners = [&](const v1::Object& object) {
    const v1::Placement& at = now.at(object.id());
    return Corners({object.width_m(), object.depth_m()}, Pose<double>{at.x_m(), at.y_m(), at.theta_rad()});
  };
  Leaders leaders;
  for (const v1::Object& rug : layout.graph().object_list().objects()) {
    if (!rug.walk_over() || locked.contains(rug.id()) || !now.contains(rug.id())) continue;
    double most_m2 = kLeastShare * rug.width_m() * rug.depth_m();
    for (const v1::Object& object : layout.graph().object_list().objects()) {
      if (object.kind() != v1::OBJECT_KIND_FLOOR || object.walk_over() || !now.contains(object.id())) continue;
      const double covered_m2 = ConvexIntersectionArea(corners(rug), corners(object));
      if (covered_m2 <= most_m2) continue;
      most_m2 = covered_m2;
      leaders[rug.id()] = object.id();
    }
  }
  return leaders;
}

// Whether what hangs there stays on its wall when it makes the same move as its leader.
bool AlongItsWall(const v1::Placement& hung, const v1::Placement& before, const v1::Placement& after) {
  constexpr double kOff_m = 0.02, kTurn_rad = 0.02;
  const double turn = std::remainder(after.theta_rad() - before.theta_rad(), 2 * std::numbers::pi);
  const double off = (after.y_m() - before.y_m()) * std::cos(hung.theta_rad()) -
                     (after.x_m() - before.x_m()) * std::sin(hung.theta_rad());
  return std::abs(turn) < kTurn_rad && std::abs(off) < kOff_m;
}

// The place of what keeps its own relative to a leader.
v1::Placement Carried(const v1::Placement& before, const v1::Placement& after, v1::Placement follower) {
  const double turn = after.theta_rad() - before.theta_rad();
  const double dx = follower.x_m() - before.x_m(), dy = follower.y_m() - before.y_m();
  follower.set_x_m(after.x_m() + dx * std::cos(turn) - dy * std::sin(turn));
  follower.set_y_m(after.y_m() + dx * std::sin(turn) + dy * std::cos(turn));
  follower.set_theta_rad(follower.theta_rad() + turn);
  return follower;
}

PlacesById PlacesOf(const v1::SolvedLayout& layout) {
  PlacesById places;
  for (const v1::Placement& at : layout.placements()) places[at.object_id()] = at;
  return places;
}

// Everything that leads moves what it leads, until all have been asked; `stay` are not asked.
PlacesById Followed(const v1::SolvedLayout& layout, const PlacesById& now, const Leaders& leaders,
                    const PlacesById& put, const IdSet& stay) {
  PlacesById moved = put;
  // Riders of riders follow too: hosts are listed before what stands on them only by chance.
  for (bool more = true; more;) {
    more = false;
    for (const v1::Object& object : layout.graph().object_list().objects()) {
      if (moved.contains(object.id()) || !now.contains(object.id()) || stay.contains(object.id())) continue;
      const auto led = leaders.find(object.id());
      const std::string host = object.kind() == v1::OBJECT_KIND_SURFACE ? object.host_id() : "";
      const auto leader = moved.find(led == leaders.end() ? host : led->second);
      if (leader == moved.end() || !now.contains(leader->first)) continue;
      const v1::Placement &before = now.at(leader->first), &at = now.at(object.id());
      if (object.kind() == v1::OBJECT_KIND_WALL && !AlongItsWall(at, before, leader->second)) continue;
      moved[object.id()] = Carried(before, leader->second, at);
      more = true;
    }
  }
  return moved;
}

// What is the matter with where things stand, by what and of whom.
using Faults = std::map<std::tuple<int, std::string, std::string>, double>;

class Fitting {
 public:
  Fitting(const v1::SolvedLayout& layout, const PlacesById& now) : scene_(SceneFromProto(layout.graph())), now_(now) {
    if (scene_.ok()) before_ = FaultsWith({});
  }

  // Of what follows in `moved`, that which would stand in the way of something that does not, or in a wall, more than
  // it does now.
  IdSet Unfit(const PlacesById& moved, const Leaders& leaders, const PlacesById& put) const {
    constexpr double kWorse_m = 1e-3;
    IdSet unfit;
    if (!scene_.ok()) return unfit;
    for (const auto& [fault, amount_m] : FaultsWith(moved)) {
      const auto& [kind, one, other] = fault;
      const auto was = before_.find(fault);
      if (amount_m < (was == before_.end() ? 0 : was->second) + kWorse_m ||
          (moved.contains(one) && moved.contains(other)))
        continue;
      for (const std::string& id : {one, other}) {
        if (leaders.contains(id) && moved.contains(id) && !put.contains(id)) unfit.insert(id);
      }
    }
    return unfit;
  }

 private:
  Faults FaultsWith(const PlacesById& moved) const {
    Layout layout(scene_->objects.size());
    std::vector<char> placed(scene_->objects.size(), 0);
    for (const PlacesById* places : {&now_, &moved}) {
      for (const auto& [id, at] : *places) {
        const int object = scene_->IndexOf(id);
        if (object < 0) continue;
        layout[object] = {at.x_m(), at.y_m(), at.theta_rad()};
        placed[object] = 1;
      }
    }
    Faults faults;
    for (const v1::Finding& one : evaluation::MeasureSolids({*scene_, layout, placed}).findings) {
      double& amount_m = faults[{one.kind(), one.object_id(), one.partner_id()}];
      amount_m = std::max(amount_m, one.amount());
    }
    return faults;
  }

  const absl::StatusOr<Scene> scene_;
  const PlacesById& now_;
  Faults before_;
};

}  // namespace

PlacesById WithFollowers(const v1::SolvedLayout& layout, const PlacesById& put) {
  const PlacesById now = PlacesOf(layout);
  Leaders leaders = DrawnUp(layout, now);
  leaders.merge(HungAbove(layout));
  leaders.merge(LainUnder(layout, now));
  PlacesById moved = Followed(layout, now, leaders, put, {});
  const bool any = std::ranges::any_of(
      moved, [&](const auto& one) { return leaders.contains(one.first) && !put.contains(one.first); });
  if (!any) return moved;
  const Fitting fitting(layout, now);
  IdSet stay;
  for (IdSet unfit = fitting.Unfit(moved, leaders, put); !unfit.empty(); unfit = fitting.Unfit(moved, leaders, put)) {
    stay.merge(unfit);
    moved = Followed(layout, now, leaders, put, stay);
  }
  return moved;
}

}  // namespace flair::session
