// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/layouts/directions.h"

#include <algorithm>
#include <cmath>

namespace flair::session {
namespace {

Vec2<double> PointOf(const v1::Placement& at) { return {at.x_m(), at.y_m()}; }

double WayLength(const Vec2<double>& way) { return std::hypot(way.x, way.y); }

// How far a point is in front of a wall.
double AwayFrom(const Wall& wall, const Vec2<double>& point) {
  return (point.x - wall.start.x) * wall.inward_normal.x + (point.y - wall.start.y) * wall.inward_normal.y;
}

// The nearest point of a wall.
Vec2<double> FootOn(const Wall& wall, const Vec2<double>& point) {
  const Vec2<double> along = wall.Along();
  const double at = (point.x - wall.start.x) * along.x + (point.y - wall.start.y) * along.y;
  return wall.PointAt(std::clamp(at, 0.0, wall.length_m));
}

}  // namespace

Vec2<double> MiddleOf(const Room& room) {
  Vec2<double> least{INFINITY, INFINITY}, most{-INFINITY, -INFINITY};
  for (const Wall& wall : room.walls) {
    least = {std::min(least.x, wall.start.x), std::min(least.y, wall.start.y)};
    most = {std::max(most.x, wall.start.x), std::max(most.y, wall.start.y)};
  }
  return {(least.x + most.x) / 2, (least.y + most.y) / 2};
}

std::optional<Vec2<double>> WayOf(const std::string& way, const v1::Placement& at) {
  const Vec2<double> front{-std::sin(at.theta_rad()), std::cos(at.theta_rad())};
  if (way == "forward") return front;
  if (way == "back") return Vec2<double>{-front.x, -front.y};
  Vec2<double> to{0, 0};
  if (way.starts_with("north")) to.y = 1;
  if (way.starts_with("south")) to.y = -1;
  if (way.ends_with("east")) to.x = 1;
  if (way.ends_with("west")) to.x = -1;
  const double length = WayLength(to);
  if (length == 0) return std::nullopt;
  return Vec2<double>{to.x / length, to.y / length};
}

int NearestWall(const Room& room, const v1::Placement& at) {
  int nearest = -1;
  double least_m = INFINITY;
  for (size_t i = 0; i < room.walls.size(); ++i) {
    const Vec2<double> foot = FootOn(room.walls[i], PointOf(at));
    const double away_m = std::hypot(foot.x - at.x_m(), foot.y - at.y_m());
    if (away_m < least_m) least_m = away_m, nearest = static_cast<int>(i);
  }
  return nearest;
}

Vec2<double> AlongWall(const Vec2<double>& way, const Room& room, const v1::Placement& at, const v1::Object& object) {
  constexpr double kAtWall_m = 0.1, kLeast = 0.2;
  const int wall = NearestWall(room, at);
  if (wall < 0) return way;
  const Vec2<double>& into = room.walls[wall].inward_normal;
  const double towards = -(way.x * into.x + way.y * into.y);
  const double reach_m = std::max(object.width_m(), object.depth_m()) / 2 + kAtWall_m;
  if (towards <= 0 || AwayFrom(room.walls[wall], PointOf(at)) > reach_m) return way;
  const Vec2<double> along{way.x + towards * into.x, way.y + towards * into.y};
  const double length = WayLength(along);
  return length < kLeast ? way : Vec2<double>{along.x / length, along.y / length};
}

int OppositeWall(const Room& room, int wall) {
  constexpr double kParallel = -0.95;
  int best = -1;
  double farthest_m = 0;
  for (size_t i = 0; wall >= 0 && i < room.walls.size(); ++i) {
    const Wall &one = room.walls[i], &other = room.walls[wall];
    const double faces = one.inward_normal.x * other.inward_normal.x + one.inward_normal.y * other.inward_normal.y;
    const double away_m = AwayFrom(other, one.PointAt(one.length_m / 2));
    if (faces < kParallel && away_m * one.length_m > farthest_m) {
      farthest_m = away_m * one.length_m;
      best = static_cast<int>(i);
    }
  }
  return best;
}

std::optional<Vec2<double>> WayTo(const Target& target, const Scene& scene, const v1::SolvedLayout& layout,
                                  const v1::Placement& at) {
  const Vec2<double> from = PointOf(at);
  std::optional<Vec2<double>> nearest;
  const auto offer = [&](const Vec2<double>& to) {
    const Vec2<double> way{to.x - from.x, to.y - from.y};
    if (!nearest.has_value() || WayLength(way) < WayLength(*nearest)) nearest = way;
  };
  const Room& room = scene.room;
  if (target.kind == "object") {
    for (const std::string& id : target.ids) {
      const v1::Placement* const to = PlaceOf(layout, id);
      if (to != nullptr && id != at.object_id()) offer(PointOf(*to));
    }
  } else if (target.kind == "middle") {
    offer(MiddleOf(room));
  } else if (target.kind == "window" || target.kind == "door") {
    const OpeningKind kind = target.kind == "window" ? OpeningKind::kWindow : OpeningKind::kDoor;
    for (const Opening& opening : room.openings) {
      if (opening.kind == kind) offer(room.walls[opening.wall].PointAt(opening.offset_m + opening.width_m / 2));
    }
  } else {
    int wall = target.wall >= 0 ? target.wall : NearestWall(room, at);
    if (target.kind == "opposite wall") wall = OppositeWall(room, wall);
    if (wall < 0) return std::nullopt;
    const Vec2<double>& into = room.walls[wall].inward_normal;
    const double away_m = AwayFrom(room.walls[wall], from);
    offer({from.x - away_m * into.x, from.y - away_m * into.y});
  }
  if (nearest.has_value() && WayLength(*nearest) < 1e-6) return std::nullopt;
  return nearest;
}

}  // namespace flair::session
