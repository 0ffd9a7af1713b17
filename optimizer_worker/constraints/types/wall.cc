// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "optimizer_worker/constraints/measure/walls.h"
#include "room/autodiff/dual.h"
#include "room/geometry/convex_piece.h"
#include "room/geometry/gap.h"
#include "room/geometry/polygon.h"
#include "room/geometry/pose.h"
#include "room/scene/room.h"

namespace flair::optimizer {
namespace {

// Keeps one side of an object (its back by default) on a wall.
//   cost = min over walls of  gap^2 + (1 - cos a) + overhang^2                                    [m2]
//   gap       signed distance of the side's middle to the wall's line, so that beyond the wall is an error too
//   a         angle between the side's outward normal and the direction into the wall
//   overhang  how far the side sticks out beyond the wall's ends (matters at inner corners)
// Zero exactly when the whole side lies on the wall. Smooth but where the nearest wall changes.
// The released ind_next_to_wall multiplies the distances to two walls, so that the same gap costs more in a larger
// room; SEMANTICS.md section 3 names this form as correct.
std::optional<Shortfall> AgainstWallShortfall(const PlacedCall& call) {
  const int object = call.object();
  const Side side = call.arguments().OneSide("side");
  return Worst(OffWall(call, object, side, call.MeantWall(side)));
}

BoundCost BindAgainstWall(const Arguments& a, const BindContext& context) {
  const int object = a.Object("object");
  const auto formula = [footprint = FootprintOf(context, object), side = a.OneSide("side"),
                        walls =
                            WallsToUse(context.scene.room, a.Walls("wall"))]<typename T>(const Frames<T, 1>& frames) {
    return LeastOf<T>(walls, frames,
                      [&](const Wall& wall, const auto& f) { return SideOnWall(footprint, f[0], side, wall); });
  };
  return MakeCost<kSeesZero>({object}, formula);
}

// Puts an object's back on a wall, in the middle of it.
//   cost = min over walls of  (cost of against_wall) + (offset - L / 2)^2                                    [m2]
//   offset  place of the back's middle along the wall of length L
// Zero exactly when the back lies on the wall, centred.
std::optional<Shortfall> CenteredOnWallShortfall(const PlacedCall& call) {
  const int object = call.object();
  const Frame<double> frame = call.FrameOf(object);
  const auto aside = [&](const Wall& w) { return w.Offset(frame.center) - w.length_m / 2; };
  const Wall& wall = call.MeantWall(Side::kBack);
  std::vector<Shortfall> misses = OffWall(call, object, Side::kBack, wall);
  misses.push_back(OffBy(call.Name(object), "the middle of " + WallName(call.scene().room, wall), aside(wall)));
  return Worst(misses);
}

BoundCost BindCenteredOnWall(const Arguments& a, const BindContext& context) {
  const int object = a.Object("object");
  const auto formula = [footprint = FootprintOf(context, object),
                        walls =
                            WallsToUse(context.scene.room, a.Walls("wall"))]<typename T>(const Frames<T, 1>& frames) {
    return LeastOf<T>(walls, frames, [&](const Wall& wall, const auto& f) {
      return SideOnWall(footprint, f[0], Side::kBack, wall) + Square(wall.Offset(f[0].center) - wall.length_m / 2);
    });
  };
  return MakeCost<kSeesZero>({object}, formula);
}

// Puts an object into a corner of the room.
//   cost = min over corners K and the two ways round of  |C - K|^2 + (1 - cos a)                           [m2]
//   C  the object's corner between the given side and its neighbour;  a  angle between the side and its wall
// Zero exactly when the given side lies on one wall of the corner and the neighbouring side on the other. Only corners
// that open inwards count. The released ind_in_corner wants the object across the corner at 45 degrees and punishes the
// flush one (SEMANTICS.md section 3).

// A corner of the room where the side can lie on the wall before or after it.
struct RoomCorner {
  Vec2<double> point;
  // The wall that the side lies on.
  Wall wall;
  // Whether the corner is at that wall's end (at the object's right when its back is on the wall).
  bool at_end;
};

// The walls before and after each corner of the room that opens inwards.
std::vector<std::pair<Wall, Wall>> CornerWalls(const Room& room) {
  std::vector<std::pair<Wall, Wall>> corners;
  for (size_t i = 0; i < room.walls.size(); ++i) {
    const Wall& before = room.walls[i];
    const Wall& after = room.walls[(i + 1) % room.walls.size()];
    if (Cross(before.Along(), after.Along()) > 1e-6) corners.emplace_back(before, after);
  }
  return corners;
}

BoundCost BindInCorner(const Arguments& a, const BindContext& context) {
  const int object = a.Object("object");
  std::vector<RoomCorner> corners;
  const std::vector<Wall> walls = WallsToUse(context.scene.room, a.Walls("wall"));
  const auto is_named = [&](const Wall& wall) {
    return std::ranges::find(walls, wall.name, &Wall::name) != walls.end();
  };
  for (const auto& [before, after] : CornerWalls(context.scene.room)) {
    if (!is_named(before) && !is_named(after)) continue;
    corners.push_back({before.end, before, true});
    corners.push_back({before.end, after, false});
  }
  const auto formula = [footprint = FootprintOf(context, object), side = a.OneSide("side"),
                        corners]<typename T>(const Frames<T, 1>& frames) {
    return LeastOf<T>(corners, frames, [&](const RoomCorner& corner, const auto& f) {
      // Walking along the wall with the room on the left, one runs against the side's outward normal turned left.
      const auto normal = NormalOf(f[0], side);
      const double half = (corner.at_end ? 1 : -1) * SideLength(footprint, side) / 2;
      const auto tip = MiddleOf(footprint, f[0], side) + half * Perpendicular(normal);
      return SquaredNorm(tip - Cast<std::decay_t<decltype(tip.x)>>(corner.point)) + TurnToWall(f[0], side, corner.wall);
    });
  };
  return MakeCost<kSeesZero>({object}, formula);
}

// Keeps one side of an object (its back by default) near a wall and turned to it.
//   cost = min over walls of  out(gap, [0, max])^2 + max(cos 45 - cos a, 0)^2 + out(offset, wall)^2        [m2]
//   gap     mean signed distance of the side's two ends to the wall's line
//   a       angle between the side's outward normal and the direction into the wall
//   offset  place of the side's middle along the wall
// Zero exactly when the side is at most max_distance_m from a wall that it looks at (within 45 degrees). The released
// ind_near_wall has no side, so that calls with one fail silently (SEMANTICS.md section 3).
std::optional<Shortfall> NearWallShortfall(const PlacedCall& call) {
  const int object = call.object();
  const Side side = call.arguments().OneSide("side");
  const double most = call.arguments().Number("max_distance_m");
  const Frame<double> frame = call.FrameOf(object);
  const Vec2<double> middle = MiddleOf(call.FootprintOf(object), frame, side);
  const auto beyond_end = [&](const Wall& w) {
    return std::max({0.0, -w.Offset(middle), w.Offset(middle) - w.length_m});
  };
  const Wall& wall = call.MeantWall(side);
  const std::string what = SideOf(call.Name(object), side), place = WallName(call.scene().room, wall);
  return Worst(
      {TooFar(what, place, wall.Height(middle), most),
       Turned(what, place, AngleOf(NormalOf(frame, side), -wall.inward_normal), kPi / 4),
       {fmt::format("{} is {:.2f} m beyond {}", what, -wall.Height(middle), place), -wall.Height(middle), "m"},
       {fmt::format("{} is {:.2f} m beyond the end of {}", what, beyond_end(wall), place), beyond_end(wall), "m"}});
}

BoundCost BindNearWall(const Arguments& a, const BindContext& context) {
  const int object = a.Object("object");
  const auto formula =
      [footprint = FootprintOf(context, object), side = a.OneSide("side"), most_m = a.Number("max_distance_m"),
       walls = WallsToUse(context.scene.room, a.Walls("wall"))]<typename T>(const Frames<T, 1>& frames) {
        return LeastOf<T>(walls, frames, [&](const Wall& wall, const auto& f) {
          constexpr double kCos45 = 0.70710678118654757;
          const auto middle = MiddleOf(footprint, f[0], side);
          return SquaredOutside(wall.Height(middle), 0, most_m) +
                 SquaredHinge(TurnToWall(f[0], side, wall) - (1 - kCos45)) +
                 SquaredOutside(wall.Offset(middle), 0, wall.length_m);
        });
      };
  return MakeCost<kSeesZero>({object}, formula);
}

// Keeps an object, or one of its sides, away from all walls.
//   cost = sum over corners C and walls of max(min - d(C, wall), 0)^2                                       [m2]
//   C  the object's corners, or the two ends of the given side;  d  signed distance to the wall's line in a convex room
// In other rooms d is the gap between the whole object and each wall, once per wall. Zero exactly when everything is at
// least min_distance_m from every wall. The released ind_not_against_wall is 10 times this, lets corners pass through
// walls and refuses the side that its own documentation names (SEMANTICS.md section 3).
std::optional<Shortfall> NotAgainstWallShortfall(const PlacedCall& call) {
  const int object = call.object();
  const std::optional<Side> side = call.arguments().MaybeSide("side");
  const Box<double> box =
      side ? Box<double>::Before(call.FootprintOf(object), call.FrameOf(object), *side, 0) : call.BoxOf(object);
  const std::string what = side ? SideOf(call.Name(object), *side) : call.Name(object);
  std::vector<Shortfall> misses;
  for (const Wall& wall : WallsToUse(call.scene().room, call.arguments().Walls("wall"))) {
    const ConvexPiece piece(Segment{wall.start, wall.end});
    misses.push_back(TooNear(what, WallName(call.scene().room, wall), Gap<double>(box, piece),
                             call.arguments().Number("min_distance_m")));
  }
  return Worst(misses);
}

BoundCost BindNotAgainstWall(const Arguments& a, const BindContext& context) {
  const int object = a.Object("object");
  const Room& room = context.scene.room;
  const std::vector<Wall> walls = WallsToUse(room, a.Walls("wall"));
  // The walls as pieces, for rooms whose walls' lines do not bound them.
  std::vector<ConvexPiece> pieces;
  for (const Wall& wall : walls) pieces.emplace_back(Segment{wall.start, wall.end});
  const auto formula = [footprint = FootprintOf(context, object), side = a.MaybeSide("side"),
                        min_m = a.Number("min_distance_m"), walls, convex = IsConvex(room.floor),
                        pieces]<typename T>(const Frames<T, 1>& frames) {
    T sum(0.0);
    if (!convex && !side.has_value()) {
      const Box<T> box(footprint, frames[0]);
      for (const ConvexPiece& piece : pieces) sum += SquaredNearness<T>(box, piece, min_m);
      return sum;
    }
    const auto corner_cost = [&](const Vec2<T>& corner) {
      for (const Wall& wall : walls) {
        const bool beside = ValueOf(wall.Offset(corner)) < 0 || ValueOf(wall.Offset(corner)) > wall.length_m;
        if (convex || !beside) sum += SquaredHinge(min_m - wall.Height(corner));
      }
    };
    if (side.has_value()) {
      const SideEdge<T> edge = EdgeOf(footprint, frames[0], *side);
      corner_cost(edge.first);
      corner_cost(edge.second);
    } else {
      for (const Vec2<T>& corner : Corners(footprint, frames[0])) corner_cost(corner);
    }
    return sum;
  };
  return MakeCost({object}, formula);
}

// Keeps an object out of the corners of the room.
//   cost = sum over corners K of max(min - max(|d_a|, |d_b|), 0)^2                                          [m2]
//   d_a, d_b  least signed distance of the object's corners to the lines of the two walls that meet at K
// Zero exactly when at every corner the object is at least min_distance_m from one of the two walls: it may stand
// against a wall, but not where two meet. Only corners that open inwards count. Kinks where the other wall is the
// farther one and where another of the object's corners is the nearest. Models call it (ind_not_in_corner); the
// released library has no such function.

// |least signed distance of the points to the wall's line|.
template <typename T, typename Points>
T Distance(const Points& points, const Wall& wall) {
  T least = wall.Height(points[0]);
  for (const Vec2<T>& point : points) {
    const T height = wall.Height(point);
    if (ValueOf(height) < ValueOf(least)) least = height;
  }
  return Magnitude(least);
}

std::optional<Shortfall> NotInCornerShortfall(const PlacedCall& call) {
  const double into = call.CostRoot();
  return Worst({{fmt::format("{} stands {:.2f} m too far into a corner", call.NameOf("object"), into), into, "m"}});
}

BoundCost BindNotInCorner(const Arguments& a, const BindContext& context) {
  const int object = a.Object("object");
  const auto formula = [footprint = FootprintOf(context, object), min_m = a.Number("min_distance_m"),
                        corners = CornerWalls(context.scene.room)]<typename T>(const Frames<T, 1>& frames) {
    const auto points = Corners(footprint, frames[0]);
    T sum(0.0);
    for (const auto& [before, after] : corners) {
      const T a = Distance<T>(points, before), b = Distance<T>(points, after);
      sum += SquaredHinge(min_m - (ValueOf(a) > ValueOf(b) ? a : b));
    }
    return sum;
  };
  return MakeCost({object}, formula);
}

// Turns an object so that its sides run along a wall.
//   cost = min over walls of sin^2(2 (theta - phi)) / 4                                                    [rad2]
//   theta  heading of the object;  phi  direction of the wall
// Zero exactly when two sides of the object are parallel to a wall, near that the square of the angle that lacks. Kinks
// half way between the directions of two walls; a rectangle has one direction. Models call it (ind_parallel_to_wall);
// the released library has no such function, only `aligned` for all objects.
// Unit vectors along the walls, one of those that are parallel or at right angles.
std::vector<Vec2<double>> DirectionsOf(const Room& room) {
  std::vector<Vec2<double>> directions;
  for (const Wall& wall : room.walls) {
    const bool known = std::ranges::any_of(directions, [&](const Vec2<double>& other) {
      return std::abs(Cross(other, wall.Along()) * Dot(other, wall.Along())) < 1e-12;
    });
    if (!known) directions.push_back(wall.Along());
  }
  return directions;
}

std::optional<Shortfall> ParallelToWallShortfall(const PlacedCall& call) {
  const double angle_rad = std::asin(std::min(1.0, 2 * call.CostRoot())) / 2;
  return Worst({Turned(call.NameOf("object"), "the direction of the nearest wall", angle_rad)});
}

BoundCost BindParallelToWall(const Arguments& a, const BindContext& context) {
  const auto formula = [directions = DirectionsOf(context.scene.room)]<typename T>(const Frames<T, 1>& frames) {
    // sin(2 a) / 2 = sin(a) cos(a), a the angle between front and wall.
    return LeastOf<T>(directions, frames, [](const Vec2<double>& direction, const auto& f) {
      const auto along = Cast<std::decay_t<decltype(f[0].front.x)>>(direction);
      return Square(Cross(along, f[0].front) * Dot(along, f[0].front));
    });
  };
  return MakeCost({a.Object("object")}, formula);
}

constexpr ConstraintCode kWallCode[] = {
    {"against_wall", BindAgainstWall, AgainstWallShortfall},
    {"centered_on_wall", BindCenteredOnWall, CenteredOnWallShortfall},
    {"in_corner", BindInCorner, nullptr, "the nearest corner that it fits"},
    {"near_wall", BindNearWall, NearWallShortfall},
    {"not_against_wall", BindNotAgainstWall, NotAgainstWallShortfall},
    {"not_in_corner", BindNotInCorner, NotInCornerShortfall},
    {"parallel_to_wall", BindParallelToWall, ParallelToWallShortfall},
};

}  // namespace

std::span<const ConstraintCode> WallCode() { return kWallCode; }

}  // namespace flair::optimizer
