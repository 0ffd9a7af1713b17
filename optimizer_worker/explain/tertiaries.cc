// SPDX-License-Identifier: GPL-3.0-or-later
// Families rug, surface, on_wall and ceiling: what is attached to something.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "fmt/format.h"
#include "optimizer_worker/constraints/measure/beside.h"
#include "optimizer_worker/constraints/room/on_wall.h"
#include "optimizer_worker/explain/scope.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {
namespace {

using Found = std::optional<Shortfall>;

// From the middle of one to the middle of the other.
Found OffMiddle(const Scope& scope, int object, int target) {
  return Worst({OffBy(scope.Name(object), "the middle of " + scope.Name(target),
                      Norm(scope.FrameOf(object).center - scope.FrameOf(target).center))});
}

Found OnTopCenter(const Scope& scope) {
  const int object = scope.arguments().Object("object"), host = scope.arguments().Object("host");
  if (const Found off = OffMiddle(scope, object, host)) return off;
  return Worst({Turned(scope.Name(object), "the direction of " + scope.Name(host),
                       AngleOf(scope.FrameOf(object).front, scope.FrameOf(host).front))});
}

Found OnTopCorner(const Scope& scope) {
  std::string corner(CornerName(scope.arguments().OneCorner("corner")));
  for (char& c : corner) c = c == '_' ? ' ' : c;
  return Worst({OffBy(scope.NameOf("object"), fmt::format("the {} corner of {}", corner, scope.NameOf("host")),
                      scope.CostRoot())});
}

Found RugUnderCenter(const Scope& scope) {
  return OffMiddle(scope, scope.arguments().Object("rug"), scope.arguments().Object("object"));
}

Found RugUnderForward(const Scope& scope) {
  const int rug = scope.arguments().Object("rug"), object = scope.arguments().Object("object");
  const Vec2<double> front = MiddleOf(scope.FootprintOf(object), scope.FrameOf(object), Side::kFront);
  if (const Found off = Worst({OffBy(scope.Name(rug), SideOf(scope.Name(object), Side::kFront),
                                     Norm(scope.FrameOf(rug).center - front))})) {
    return off;
  }
  return Worst({OffBy(scope.Name(rug), "lying along " + scope.Name(object), scope.CostRoot())});
}

Found CeilingAbove(const Scope& scope) {
  return OffMiddle(scope, scope.arguments().Object("object"), scope.arguments().Object("target"));
}

Found CeilingCenter(const Scope& scope) {
  return Worst({OffBy(scope.NameOf("object"), "the middle of the ceiling", scope.CostRoot())});
}

// The wall that a hanging object is on.
const Wall& WallOf(const Scope& scope, int object) {
  const Wall* best = &scope.scene().room.walls.front();
  double least = std::numeric_limits<double>::infinity();
  for (const Wall& wall : scope.scene().room.walls) {
    const double off = SideOnWall(scope.FootprintOf(object), scope.FrameOf(object), Side::kBack, wall);
    if (off < least) least = off, best = &wall;
  }
  return *best;
}

// How an object misses hanging on any wall.
Shortfall NotHanging(const Scope& scope, int object) {
  const Scene& scene = scope.scene();
  double least = std::numeric_limits<double>::infinity();
  for (const HangingWall& place : HangingWalls(scene.room, scene.BottomOf(object), scene.TopOf(object))) {
    least = std::min(least, HangsOn(scope.FootprintOf(object), scope.FrameOf(object), place));
  }
  return OffBy(scope.Name(object), "a place flat on one wall, clear of its doors and windows",
               std::isfinite(least) ? std::sqrt(least) : 0);
}

// Metres along the wall from the object's middle to the interval that the target covers; and how far the target stands
// from that wall.
std::vector<Shortfall> Beside(const Scope& scope, double most_along_m, double most_away_m, const char* place) {
  const int object = scope.arguments().Object("object"), target = scope.arguments().Object("target");
  const Wall& wall = WallOf(scope, object);
  const WallView<double> view(scope.FootprintOf(target), scope.FrameOf(target), wall);
  const double offset = wall.Offset(scope.FrameOf(object).center);
  const double along = std::max({0.0, view.low - offset, offset - view.high});
  const double from_middle = std::abs(offset - view.Middle());
  const bool above = most_along_m == 0;
  return {{fmt::format("{} hangs {:.2f} m along the wall from {} {}", scope.Name(object), above ? from_middle : along,
                       place, scope.Name(target)),
           (above ? from_middle : along) - most_along_m, "m"},
          TooFar(scope.Name(target), fmt::format("{}, where {} hangs", WallName(wall), scope.Name(object)),
                 view.distance, most_away_m),
          NotHanging(scope, object)};
}

Found OnWallNear(const Scope& scope) {
  const double reach = scope.FootprintOf(scope.arguments().Object("object")).width_m / 2 + 0.5;
  return Worst(Beside(scope, reach, 0.5, "beside"));
}

Found OnWallAbove(const Scope& scope) { return Worst(Beside(scope, 0, 0.15, "the middle of")); }

Found OnWallFacing(const Scope& scope) {
  const int object = scope.arguments().Object("object"), target = scope.arguments().Object("target");
  const Frame<double> frame = scope.FrameOf(target);
  const Vec2<double> p = frame.ToObject(scope.FrameOf(object).center);
  const double aside = std::abs(p.x) - scope.FootprintOf(target).width_m / 4;
  return Worst({{fmt::format("{} hangs {:.2f} m to the side of where {} looks", scope.Name(object),
                             std::max(0.0, aside), scope.Name(target)),
                 aside, "m"},
                {fmt::format("{} hangs {:.2f} m behind {}", scope.Name(object), -p.y, scope.Name(target)), -p.y, "m"},
                Turned(SideOf(scope.Name(target), Side::kFront), scope.Name(object),
                       kPi - AngleOf(frame.front, scope.FrameOf(object).front)),
                NotHanging(scope, object)});
}

Found OnWallInZone(const Scope& scope) {
  const Zone& zone = scope.scene().zones[static_cast<size_t>(scope.arguments().Zone("zone"))];
  return Worst({OffBy(scope.NameOf("object"), fmt::format("the {} zone", zone.name), scope.CostRoot() / 2)});
}

}  // namespace

Explainer FindTertiaryExplainer(std::string_view type) {
  static const std::map<std::string_view, Explainer> explainers = {
      {"ceiling_above", CeilingAbove},        {"ceiling_center", CeilingCenter}, {"on_top_center", OnTopCenter},
      {"on_top_corner", OnTopCorner},         {"on_wall_above", OnWallAbove},    {"on_wall_facing", OnWallFacing},
      {"on_wall_in_zone", OnWallInZone},      {"on_wall_near", OnWallNear},      {"rug_under_center", RugUnderCenter},
      {"rug_under_forward", RugUnderForward},
  };
  const auto found = explainers.find(type);
  return found == explainers.end() ? nullptr : found->second;
}

}  // namespace flair::optimizer
