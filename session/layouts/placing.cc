// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/layouts/placing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fmt/format.h"
#include "room/geometry/pose.h"
#include "session/layouts/following.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::session {
namespace {

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
  std::map<std::string, v1::Placement> moved;
  for (const v1::Placement& to : placements) moved[to.object_id()] = to;
  moved = WithFollowers(layout, moved);
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
