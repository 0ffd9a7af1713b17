// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "optimizer_worker/constraints/measure/hanging.h"
#include "optimizer_worker/constraints/measure/walls.h"
#include "optimizer_worker/constraints/shortfall.h"
#include "optimizer_worker/constraints/whole_room.h"
#include "room/geometry/polygon.h"
#include "room/geometry/pose.h"
#include "room/scene/scene.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::optimizer {
namespace {

// Hangs a wall object on a wall, off the openings.
//   cost = min over walls of ( gap^2 + (1 - cos a) + overhang^2 + sum over openings of overlap^2 )   [m2]
//   gap, a, overhang  as in against_wall, for the back
//   overlap           shortest slide along the wall that takes the object off a door or window, when their heights meet
// Zero exactly when the back is flush on one wall and off its openings. The paper's Eq. on_wall is a product over all
// walls with headings that are not reduced, so that a painting flush on the south wall at 2 pi costs millions
// (SEMANTICS.md section 5): here the least wall counts.
// The first object, hung on the wall where that costs least.
template <typename T, size_t K>
T Hangs(const Footprint& footprint, const std::array<Frame<T>, K>& frames, const std::vector<HangingWall>& places) {
  return LeastOf<T>(places, frames,
                    [&](const HangingWall& place, const auto& f) { return HangsOn(footprint, f[0], place); });
}

// How an object misses hanging on any wall.
Shortfall NotHanging(const PlacedCall& call, int object) {
  const double least = Hangs<double>(call.FootprintOf(object), Frames<double, 1>{call.FrameOf(object)},
                                     HangingWalls(call.scene(), object));
  return OffBy(call.Name(object), "a place flat on one wall, clear of its doors and windows", std::sqrt(least));
}

// How `object` misses hanging beside `target`: metres along the wall from its middle to the interval that the target
// covers (to the middle of it when most_along_m is 0), and how far the target stands from that wall.
std::vector<Shortfall> OffBeside(const PlacedCall& call, double most_along_m, double most_away_m, const char* place) {
  const int object = call.object(), target = call.target();
  const Wall& wall = call.BestWall(
      [&](const Wall& w) { return SideOnWall(call.FootprintOf(object), call.FrameOf(object), Side::kBack, w); });
  const WallView<double> view(call.FootprintOf(target), call.FrameOf(target), wall);
  const double offset = wall.Offset(call.FrameOf(object).center);
  const bool above = most_along_m == 0;
  const double along =
      above ? std::abs(offset - view.Middle()) : std::max({0.0, view.low - offset, offset - view.high});
  return {
      {fmt::format("{} hangs {:.2f} m along the wall from {} {}", call.Name(object), along, place, call.Name(target)),
       along - most_along_m, "m"},
      TooFar(call.Name(target), fmt::format("{}, where {} hangs", WallName(call.scene().room, wall), call.Name(object)),
             view.distance, most_away_m),
      NotHanging(call, object)};
}

BoundCost BindOnWall(const Arguments& a, const BindContext& context) {
  std::unique_ptr<Cost> cost = OnWall(context.scene, a.Object("object"));
  if (cost != nullptr) return cost;
  return absl::FailedPreconditionError("the object does not hang on walls");
}

// Hangs a wall object above a floor object.
//   cost = min over walls of  (on_wall) + max(|m_1 - m_2| - play, 0)^2 + max(p - max(p_min, 0.15), 0)^2            [m2]
//   on_wall   cost of hanging on that wall, off its openings
//   m_1, m_2  middles of the two along the wall;  p, p_min  as in on_wall_near
//   play      0 for the only thing above the target, else what it can move above it: several share the place
// A seat's own walls are those behind it: on others the square of measure/hanging.h's turn is added. Zero exactly when
// it hangs on the wall that the target stands at, above its middle.
std::optional<Shortfall> OnWallAboveShortfall(const PlacedCall& call) {
  std::vector<Shortfall> misses = OffBeside(call, 0, 0.15, "the middle of");
  const Wall& wall = call.BestWall([&](const Wall& w) {
    return SideOnWall(call.FootprintOf(call.object()), call.FrameOf(call.object()), Side::kBack, w);
  });
  const Frame<double> target = call.FrameOf(call.target());
  if (call.scene().objects[static_cast<size_t>(call.target())].seat) {
    misses.push_back(
        Turned(SideOf(call.Name(call.target()), Side::kBack),
               fmt::format("{}, where {} hangs", WallName(call.scene().room, wall), call.Name(call.object())),
               AngleOf(-target.front, -wall.inward_normal), kPi / 4));
  }
  return Worst(misses);
}

BoundCost BindOnWallAbove(const Arguments& a, const BindContext& context) {
  const int object = a.Object("object"), target = a.Object("target");
  const bool is_seat = context.scene.objects[static_cast<size_t>(target)].seat;
  const bool shares = context.linked != nullptr && context.linked->CountAbove(target) > 1;
  const Footprint hung = FootprintOf(context, object), host = FootprintOf(context, target);
  const auto formula = [=, places = HangingWalls(context.scene, object)]<typename T>(const Frames<T, 2>& frames) {
    const NearestWall nearest = NearestWallTo(host, ValueOf(frames[1]), places, is_seat);
    return LeastOf<T>(places, frames, [&](const HangingWall& place, const auto& f) {
      using S = std::decay_t<decltype(f[0].center.x)>;
      constexpr double kAtWall_m = 0.15;
      const WallView<S> view(host, f[1], place.wall);
      const S beside = Magnitude(place.wall.Offset(f[0].center) - view.Middle());
      const S play = shares ? Positive(0.5 * (view.Length() - hung.width_m)) : S(0.0);
      const S turned = is_seat ? TurnedFrom(f[1], place.wall) : S(0.0);
      return HangsOn(hung, f[0], place) + SquaredHinge(beside - play) + Square(turned) +
             SquaredNotItsWall(host, f[1], view.distance, nearest, kAtWall_m);
    });
  };
  return MakeCost<kSeesZero>({object, target}, formula);
}

// Hangs a wall object where a floor object looks: a television before the sofa, a mirror before the chair, a screen
// before the end of a table.
//   cost = (on_wall) + max(|u| - w / 4, 0)^2 + max(-v, 0)^2 + (1 + f1 . f2)                                       [m2]
//   on_wall  cost of hanging on the best wall
//   u, v     how far along and ahead of the target's side the object's centre is;  w  the side's length;  f1, f2  the
//            object's front direction and the side's outward one
// Zero exactly when it hangs on a wall straight ahead of the side's middle half, looking back at it.
Side SideLookedFrom(const Arguments& a) { return a.MaybeSide("target_side").value_or(Side::kFront); }

// A point in the target's frame, along and ahead of that side.
template <typename T>
Vec2<T> BeforeSide(Side side, const Vec2<T>& p) {
  const Vec2<double> ahead = LocalNormal(side);
  return {p.x * ahead.y - p.y * ahead.x, p.x * ahead.x + p.y * ahead.y};
}

std::optional<Shortfall> OnWallFacingShortfall(const PlacedCall& call) {
  const int object = call.object(), target = call.target();
  const Side side = SideLookedFrom(call.arguments());
  const Vec2<double> p = BeforeSide(side, call.FrameOf(target).ToObject(call.FrameOf(object).center));
  const double aside = std::abs(p.x) - SideLength(call.FootprintOf(target), side) / 4;
  const Vec2<double> outward = EdgeOf(call.FootprintOf(target), call.FrameOf(target), side).outward_normal;
  return Worst(
      {{fmt::format("{} hangs {:.2f} m to the side of where {} looks", call.Name(object), std::max(0.0, aside),
                    call.Name(target)),
        aside, "m"},
       {fmt::format("{} hangs {:.2f} m behind {}", call.Name(object), -p.y, call.Name(target)), -p.y, "m"},
       Turned(SideOf(call.Name(target), side), call.Name(object), kPi - AngleOf(outward, call.FrameOf(object).front)),
       NotHanging(call, object)});
}

BoundCost BindOnWallFacing(const Arguments& a, const BindContext& context) {
  const int object = a.Object("object"), target = a.Object("target");
  const Side side = SideLookedFrom(a);
  const auto formula = [hung = FootprintOf(context, object), host = FootprintOf(context, target), side,
                        places = HangingWalls(context.scene, object)]<typename T>(const Frames<T, 2>& frames) {
    const Vec2<T> p = BeforeSide(side, frames[1].ToObject(frames[0].center));
    const double length_m = SideLength(host, side);
    return Hangs<T>(hung, frames, places) + SquaredOutside(p.x, -length_m / 4, length_m / 4) + SquaredHinge(-p.y) +
           (Dot(frames[0].front, EdgeOf(host, frames[1], side).outward_normal) + 1.0);
  };
  return MakeCost({object, target}, formula);
}

// Hangs a wall object in a zone.
//   cost = (zone cost of measure/walls.h) + (cost of on_wall) [m2]
// Zero exactly when it hangs on a wall, its centre in the zone's Voronoi cell. The released on_wall_in_region is the
// first part; the second is there so that the call alone says all of its sentence.
BoundCost BindOnWallInZone(const Arguments& a, const BindContext& context) {
  const int object = a.Object("object");
  const int zone = a.Zone("zone");
  RETURN_IF_ERROR(CheckHasPlace(context, zone));
  const auto formula = [footprint = FootprintOf(context, object), places = HangingWalls(context.scene, object), zone,
                        centers = std::vector(context.zone_centers.begin(), context.zone_centers.end())]<typename T>(
                           const Frames<T, 1>& frames) {
    return SquaredBeyondBorders<T>(frames[0].center, centers, zone) + Hangs<T>(footprint, frames, places);
  };
  return MakeCost({object}, formula);
}

// Hangs a wall object near a floor object.
//   cost = min over walls of  (on_wall) + max(s - 0.5, 0)^2 + max(p - max(p_min, 0.5), 0)^2                      [m2]
//   on_wall  cost of hanging on that wall, off its openings
//   s        gap between the two along the wall;  p  distance of the target's nearest corner to that wall, p_min to any
//   wall
// Zero exactly when it hangs on the target's nearest wall (or one within half a metre of it), at most half a metre
// beside it. The released on_wall_near adds the squared distance of the centres and is never zero (SEMANTICS.md section
// 6).
std::optional<Shortfall> OnWallNearShortfall(const PlacedCall& call) {
  const double reach = call.FootprintOf(call.object()).width_m / 2 + 0.5;
  return Worst(OffBeside(call, reach, 0.5, "beside"));
}

BoundCost BindOnWallNear(const Arguments& a, const BindContext& context) {
  const int object = a.Object("object"), target = a.Object("target");
  const Footprint hung = FootprintOf(context, object), host = FootprintOf(context, target);
  const auto formula = [=, places = HangingWalls(context.scene, object)]<typename T>(const Frames<T, 2>& frames) {
    const NearestWall nearest = NearestWallTo(host, ValueOf(frames[1]), places);
    return LeastOf<T>(places, frames, [&](const HangingWall& place, const auto& f) {
      using S = std::decay_t<decltype(f[0].center.x)>;
      constexpr double kBeside_m = 0.5;
      const WallView<S> view(host, f[1], place.wall);
      const S offset = place.wall.Offset(f[0].center);
      const double reach = hung.width_m / 2 + kBeside_m;
      return HangsOn(hung, f[0], place) + SquaredHinge(view.low - offset - reach) +
             SquaredHinge(offset - view.high - reach) +
             SquaredNotItsWall(host, f[1], view.distance, nearest, kBeside_m);
    });
  };
  return MakeCost<kSeesZero>({object, target}, formula);
}

constexpr ConstraintCode kOnWallCode[] = {
    {"on_wall", BindOnWall},
    {"on_wall_above", BindOnWallAbove, OnWallAboveShortfall},
    {"on_wall_facing", BindOnWallFacing, OnWallFacingShortfall},
    {"on_wall_in_zone", BindOnWallInZone, OffZone},
    {"on_wall_near", BindOnWallNear, OnWallNearShortfall},
};

}  // namespace

std::unique_ptr<Cost> OnWall(const Scene& scene, int object) {
  const Object& o = scene.objects[static_cast<size_t>(object)];
  if (o.kind != ObjectKind::kWall) return nullptr;
  return MakeCost<kSeesZero>({object}, [footprint = o.footprint, places = HangingWalls(scene, object)]<typename T>(
                                           const Frames<T, 1>& frames) { return Hangs<T>(footprint, frames, places); });
}

std::span<const ConstraintCode> OnWallCode() { return kOnWallCode; }

}  // namespace flair::optimizer
