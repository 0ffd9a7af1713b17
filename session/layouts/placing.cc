// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/layouts/placing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "fmt/format.h"
#include "room/geometry/pose.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::session {
namespace {

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
std::map<std::string, std::string> DrawnUp(const v1::SolvedLayout& layout, const Placements& now) {
  std::map<std::string, const v1::Object*> floor;
  for (const v1::Object& object : layout.graph().object_list().objects()) {
    if (object.kind() == v1::OBJECT_KIND_FLOOR && !object.walk_over()) floor[object.id()] = &object;
  }
  const IdSet locked = IdsOf(layout.graph().pinned_placements()), uses = UsesOf(layout.graph());
  const auto area = [](const v1::Object& object) { return object.width_m() * object.depth_m(); };
  std::map<std::string, std::string> leaders;
  const auto pair = [&](const std::string& one, const std::string& other) {
    const auto a = floor.find(one), b = floor.find(other);
    if (a == floor.end() || b == floor.end() || one == other || !now.contains(one) || !now.contains(other)) return;
    const auto& [small, large] = area(*a->second) < area(*b->second) ? std::pair(a, b) : std::pair(b, a);
    if (locked.contains(small->first) || area(*small->second) >= area(*large->second)) return;
    if (GapBetween(*small->second, *now.at(small->first), *large->second, *now.at(large->first)) > kDrawnUp_m) return;
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
std::map<std::string, std::string> HungAbove(const v1::SolvedLayout& layout) {
  const IdSet locked = IdsOf(layout.graph().pinned_placements());
  IdSet walls;
  for (const v1::Object& object : layout.graph().object_list().objects()) {
    if (object.kind() == v1::OBJECT_KIND_WALL) walls.insert(object.id());
  }
  std::map<std::string, std::string> leaders;
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

absl::Status CheckPlacement(const v1::Placement& placement, std::string_view path) {
  constexpr double kFar_m = 1000;
  for (const auto& [name, value] :
       {std::pair("x_m", placement.x_m()), std::pair("y_m", placement.y_m()), std::pair("z_m", placement.z_m())}) {
    if (!(std::abs(value) <= kFar_m)) {
      return InvalidArgument("{}.{}: {}; must be within {} m of the room's origin", path, name, value, kFar_m);
    }
  }
  if (!(std::abs(placement.theta_rad()) <= 1e6)) {
    return InvalidArgument("{}.theta_rad: {} is not an angle in radians", path, placement.theta_rad());
  }
  return absl::OkStatus();
}

}  // namespace

Placements PlacementsOf(v1::SolvedLayout& layout) {
  Placements by_id;
  for (v1::Placement& placement : *layout.mutable_placements()) by_id[placement.object_id()] = &placement;
  return by_id;
}

absl::Status Place(v1::SolvedLayout& layout, const google::protobuf::RepeatedPtrField<v1::Placement>& placements,
                   std::string_view path) {
  if (placements.empty()) return InvalidArgument("{}: is empty; say which objects stand where", path);
  if (placements.size() > 1000) return InvalidArgument("{}: {} objects; at most 1000 at once", path, placements.size());
  Placements now = PlacementsOf(layout);
  const IdSet known = IdsOf(layout.graph().object_list().objects());
  IdSet named;
  for (int i = 0; i < placements.size(); ++i) {
    const v1::Placement& to = placements[i];
    if (!known.contains(to.object_id())) {
      return InvalidArgument("{}[{}].object_id: \"{}\" is not an object of the room", path, i,
                             to.object_id().substr(0, 80));
    }
    if (!named.insert(to.object_id()).second) {
      return InvalidArgument("{}[{}].object_id: \"{}\" is named twice", path, i, to.object_id());
    }
    RETURN_IF_ERROR(CheckPlacement(to, fmt::format("{}[{}]", path, i)));
  }
  // Riders of riders follow too: hosts are listed before what stands on them only by chance.
  std::map<std::string, v1::Placement> moved;
  for (const v1::Placement& to : placements) moved[to.object_id()] = to;
  const std::map<std::string, std::string> drawn_up = DrawnUp(layout, now), hung = HungAbove(layout);
  const auto leader_of = [&](const v1::Object& object) -> std::string {
    if (const auto seat = drawn_up.find(object.id()); seat != drawn_up.end()) return seat->second;
    if (const auto above = hung.find(object.id()); above != hung.end()) return above->second;
    // A rug belongs to a bed without standing on it.
    return object.kind() == v1::OBJECT_KIND_SURFACE ? object.host_id() : "";
  };
  for (bool more = true; more;) {
    more = false;
    for (const v1::Object& object : layout.graph().object_list().objects()) {
      const auto leader = moved.find(leader_of(object));
      if (leader == moved.end() || moved.contains(object.id()) || !now.contains(object.id())) continue;
      const auto from = now.find(leader->first);
      if (from == now.end()) continue;
      const bool hangs = object.kind() == v1::OBJECT_KIND_WALL;
      if (hangs && !AlongItsWall(*now[object.id()], *from->second, leader->second)) continue;
      moved[object.id()] = Carried(*from->second, leader->second, *now[object.id()]);
      more = true;
    }
  }
  for (const auto& [id, placement] : moved) {
    const auto at = now.find(id);
    v1::Placement& to = *(at == now.end() ? layout.add_placements() : at->second);
    to = placement;
    // As every other stage takes it.
    to.set_theta_rad(WrapHeading(placement.theta_rad()));
  }
  return absl::OkStatus();
}

namespace {

// A wall as it is seen from a point within the room.
struct NearWall {
  double away_m = INFINITY;
  double foot_x_m = 0, foot_y_m = 0;
  // Into the room.
  double x = 0, y = 0;
};

NearWall NearestWall(const v1::Room& room, double x_m, double y_m) {
  const auto& corners = room.floor().vertices();
  double area = 0;
  for (int i = 0; i < corners.size(); ++i) {
    const v1::Point2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    area += a.x_m() * b.y_m() - b.x_m() * a.y_m();
  }
  NearWall nearest;
  for (int i = 0; i < corners.size(); ++i) {
    const v1::Point2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const double dx = b.x_m() - a.x_m(), dy = b.y_m() - a.y_m(), length = std::hypot(dx, dy);
    if (length < 1e-6) continue;
    const double along = ((x_m - a.x_m()) * dx + (y_m - a.y_m()) * dy) / length;
    const double at = std::clamp(along, 0.0, length) / length;
    NearWall wall{.foot_x_m = a.x_m() + at * dx, .foot_y_m = a.y_m() + at * dy};
    wall.away_m = std::hypot(x_m - wall.foot_x_m, y_m - wall.foot_y_m);
    const double side = area > 0 ? 1 : -1;
    wall.x = -side * dy / length;
    wall.y = side * dx / length;
    if (wall.away_m < nearest.away_m) nearest = wall;
  }
  return nearest;
}

}  // namespace

void FaceIntoRoom(const v1::Room& room, const v1::Object& object, bool put_there, v1::Placement& at) {
  // Within this of a wall something is meant to be at it.
  constexpr double kAtWall_m = 0.6, kTouching_m = 0.1, kFlush_m = 1e-3, kFacesWall = -0.7;
  const NearWall wall = NearestWall(room, at.x_m(), at.y_m());
  const double into_room = WrapHeading(std::atan2(-wall.x, wall.y));
  const double faces = -std::sin(at.theta_rad()) * wall.x + std::cos(at.theta_rad()) * wall.y;
  if (object.kind() == v1::OBJECT_KIND_WALL) {
    const bool hangs = faces > 1 - 1e-6 && std::abs(wall.away_m - object.depth_m() / 2) < kFlush_m;
    if (put_there && (hangs || wall.away_m > kAtWall_m)) return;
    at.set_theta_rad(into_room);
    at.set_x_m(wall.foot_x_m + wall.x * object.depth_m() / 2);
    at.set_y_m(wall.foot_y_m + wall.y * object.depth_m() / 2);
    return;
  }
  if (object.kind() != v1::OBJECT_KIND_FLOOR || object.walk_over() || !put_there) return;
  if (faces < kFacesWall && wall.away_m < object.depth_m() / 2 + kTouching_m) at.set_theta_rad(into_room);
}

}  // namespace flair::session
