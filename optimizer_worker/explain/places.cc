// SPDX-License-Identifier: GPL-3.0-or-later
// Families wall, feature and space: one object against the room.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "fmt/format.h"
#include "optimizer_worker/constraints/measure/walls.h"
#include "optimizer_worker/constraints/space/accessible.h"
#include "optimizer_worker/explain/scope.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {
namespace {

using Found = std::optional<Shortfall>;

// The wall of least `cost(wall)`.
template <typename WallCost>
const Wall& BestWall(const Scope& scope, const WallCost& cost) {
  const std::vector<Wall>& walls = scope.scene().room.walls;
  const int named = scope.arguments().Has("wall") ? scope.arguments().MaybeWall("wall") : -1;
  if (named >= 0) return walls[static_cast<size_t>(named)];
  return *std::min_element(walls.begin(), walls.end(), [&](const Wall& a, const Wall& b) { return cost(a) < cost(b); });
}

// How a side misses lying on a wall.
std::vector<Shortfall> MissesOnWall(const Scope& scope, int object, Side side, const Wall& wall) {
  const Footprint& footprint = scope.FootprintOf(object);
  const Frame<double> frame = scope.FrameOf(object);
  const Vec2<double> middle = MiddleOf(footprint, frame, side);
  const std::string what = SideOf(scope.Name(object), side), place = WallName(wall);
  const double overhang = std::sqrt(SquaredOverhang(footprint, middle, side, wall));
  return {
      OffBy(what, place, wall.Height(middle)),
      Turned(what, place, AngleOf(NormalOf(frame, side), -wall.inward_normal)),
      {fmt::format("{} reaches {:.2f} m beyond the end of {}", scope.Name(object), overhang, place), overhang, "m"}};
}

Found AgainstWall(const Scope& scope) {
  const int object = scope.arguments().Object("object");
  const Side side = scope.arguments().OneSide("side");
  const Wall& wall = BestWall(
      scope, [&](const Wall& w) { return SideOnWall(scope.FootprintOf(object), scope.FrameOf(object), side, w); });
  return Worst(MissesOnWall(scope, object, side, wall));
}

Found CenteredOnWall(const Scope& scope) {
  const int object = scope.arguments().Object("object");
  const Frame<double> frame = scope.FrameOf(object);
  const auto aside = [&](const Wall& w) { return w.Offset(frame.center) - w.length_m / 2; };
  const Wall& wall = BestWall(scope, [&](const Wall& w) {
    return SideOnWall(scope.FootprintOf(object), frame, Side::kBack, w) + aside(w) * aside(w);
  });
  std::vector<Shortfall> misses = MissesOnWall(scope, object, Side::kBack, wall);
  misses.push_back(OffBy(scope.Name(object), "the middle of " + WallName(wall), aside(wall)));
  return Worst(misses);
}

Found NearWall(const Scope& scope) {
  const int object = scope.arguments().Object("object");
  const Side side = scope.arguments().OneSide("side");
  const double most = scope.arguments().Number("max_distance_m");
  const Frame<double> frame = scope.FrameOf(object);
  const Vec2<double> middle = MiddleOf(scope.FootprintOf(object), frame, side);
  const auto beyond_end = [&](const Wall& w) {
    return std::max({0.0, -w.Offset(middle), w.Offset(middle) - w.length_m});
  };
  const Wall& wall = BestWall(scope, [&](const Wall& w) {
    const double turn = TurnToWall(frame, side, w), height = w.Height(middle);
    const double off = std::max({0.0, height - most, -height});
    return off * off + std::max(0.0, turn - 1 + std::sqrt(0.5)) + beyond_end(w) * beyond_end(w);
  });
  const std::string what = SideOf(scope.Name(object), side), place = WallName(wall);
  return Worst(
      {TooFar(what, place, wall.Height(middle), most),
       Turned(what, place, AngleOf(NormalOf(frame, side), -wall.inward_normal), kPi / 4),
       {fmt::format("{} is {:.2f} m beyond {}", what, -wall.Height(middle), place), -wall.Height(middle), "m"},
       {fmt::format("{} is {:.2f} m beyond the end of {}", what, beyond_end(wall), place), beyond_end(wall), "m"}});
}

Found NotAgainstWall(const Scope& scope) {
  const int object = scope.arguments().Object("object");
  const std::optional<Side> side = scope.arguments().MaybeSide("side");
  const Box<double> box =
      side ? Box<double>::Before(scope.FootprintOf(object), scope.FrameOf(object), *side, 0) : scope.BoxOf(object);
  const std::string what = side ? SideOf(scope.Name(object), *side) : scope.Name(object);
  std::vector<Shortfall> misses;
  for (const Wall& wall : scope.scene().room.walls) {
    const ConvexPiece piece(Segment{wall.start, wall.end});
    misses.push_back(
        TooNear(what, WallName(wall), Gap<double>(box, piece), scope.arguments().Number("min_distance_m")));
  }
  return Worst(misses);
}

Found InCorner(const Scope& scope) {
  const int object = scope.arguments().Object("object");
  return Worst({OffBy(scope.Name(object), "the nearest corner that it fits", scope.CostRoot())});
}

Found NotInCorner(const Scope& scope) {
  const double into = scope.CostRoot();
  return Worst({{fmt::format("{} stands {:.2f} m too far into a corner", scope.NameOf("object"), into), into, "m"}});
}

Found ParallelToWall(const Scope& scope) {
  const double angle_rad = std::asin(std::min(1.0, 2 * scope.CostRoot())) / 2;
  return Worst({Turned(scope.NameOf("object"), "the direction of the nearest wall", angle_rad)});
}

// The features of the call's kind with the gap to the object, nearest first.
double NearestFeature(const Scope& scope, int object) {
  const std::optional<Side> side =
      scope.arguments().Has("side") ? scope.arguments().MaybeSide("side") : std::optional<Side>();
  double nearest = std::numeric_limits<double>::infinity();
  for (const Segment& segment : FeatureSegments(scope.scene().room, scope.arguments().Feature("feature"))) {
    const Box<double> box =
        side ? Box<double>::Before(scope.FootprintOf(object), scope.FrameOf(object), *side, 0) : scope.BoxOf(object);
    nearest = std::min(nearest, Gap<double>(box, ConvexPiece(segment)));
  }
  return nearest;
}

std::string FeatureOf(const Scope& scope) {
  const FeatureKind kind = scope.arguments().Feature("feature");
  const bool several = FeatureSegments(scope.scene().room, kind).size() > 1;
  return fmt::format("the {}{}", several ? "nearest " : "", std::string(FeatureName(kind)));
}

Found CloseToFeature(const Scope& scope) {
  const int object = scope.arguments().Object("object");
  return Worst({TooFar(scope.NameOf("object"), FeatureOf(scope), NearestFeature(scope, object),
                       scope.arguments().Number("max_distance_m"))});
}

Found AwayFromFeature(const Scope& scope) {
  const int object = scope.arguments().Object("object");
  return Worst({TooNear(scope.NameOf("object"), FeatureOf(scope), NearestFeature(scope, object),
                        scope.arguments().Number("min_distance_m"))});
}

Found ClearOfFeature(const Scope& scope) {
  const double depth = scope.CostRoot();
  return Worst(
      {{fmt::format("{} reaches {:.2f} m into the floor before {}", scope.NameOf("object"), depth, FeatureOf(scope)),
        depth, "m"}});
}

Found FacesFeature(const Scope& scope) {
  const Frame<double> frame = scope.FrameOf(scope.arguments().Object("object"));
  double least = kPi;
  for (const Segment& s : FeatureSegments(scope.scene().room, scope.arguments().Feature("feature"))) {
    const Vec2<double> start = frame.ToObject(s.start), end = frame.ToObject(s.end);
    if (end.x <= 0 && start.x >= 0 && start.y + end.y >= 0) return std::nullopt;
    least = std::min({least, AngleOf(frame.front, s.start - frame.center), AngleOf(frame.front, s.end - frame.center)});
  }
  return Worst({Turned(SideOf(scope.NameOf("object"), Side::kFront), FeatureOf(scope), least)});
}

Found UnderWindow(const Scope& scope) {
  return Worst({OffBy(scope.NameOf("object"), "its place under the nearest window", scope.CostRoot())});
}

Found Accessible(const Scope& scope) {
  const int object = scope.arguments().Object("object");
  const double depth =
      scope.arguments().Has("min_clearance_m") ? scope.arguments().Number("min_clearance_m") : kStandingRoom_m;
  std::vector<Shortfall> misses;
  for (Side side : scope.arguments().Sides("sides")) {
    const Box<double> strip = Box<double>::Before(scope.FootprintOf(object), scope.FrameOf(object), side, depth);
    const std::string floor = fmt::format("the {:.2f} m before {}", depth, SideOf(scope.Name(object), side));
    for (int i = 0; i < static_cast<int>(scope.scene().objects.size()); ++i) {
      const Object& other = scope.scene().objects[static_cast<size_t>(i)];
      const bool belongs = scope.where().linked != nullptr && scope.where().linked->BelongsAt(object, i, side);
      if (i == object || other.kind != ObjectKind::kFloor || other.walk_over || belongs) continue;
      const double into = -Gap<double>(strip, scope.BoxOf(i));
      misses.push_back({fmt::format("{} reaches {:.2f} m into {}", scope.Name(i), into, floor), into, "m"});
    }
    for (const Wall& wall : scope.scene().room.walls) {
      double beyond = 0;
      for (int k = 0; k < 4; ++k) beyond = std::max(beyond, -wall.Height(strip.value(k)));
      misses.push_back({fmt::format("{} are cut off by {} by {:.2f} m", floor, WallName(wall), beyond), beyond, "m"});
    }
  }
  if (const Found worst = Worst(misses)) return worst;
  const double into = scope.CostRoot();
  return Worst({{fmt::format("a door swings {:.2f} m into the floor before {}", into, scope.Name(object)), into, "m"}});
}

Found Central(const Scope& scope) {
  return Worst({OffBy(scope.NameOf("object"), "the middle third of the room", scope.CostRoot())});
}

Found FacingIntoRoom(const Scope& scope) {
  const Frame<double> frame = scope.FrameOf(scope.arguments().Object("object"));
  const Vec2<double> center = BoundsOf(scope.scene().room.floor).Center();
  return Worst({Turned(SideOf(scope.NameOf("object"), Side::kFront), "the middle of the room",
                       AngleOf(frame.front, center - frame.center), kPi / 4)});
}

Found InZone(const Scope& scope) {
  const Zone& zone = scope.scene().zones[static_cast<size_t>(scope.arguments().Zone("zone"))];
  return Worst({OffBy(scope.NameOf("object"), fmt::format("the {} zone", zone.name), scope.CostRoot() / 2)});
}

}  // namespace

Explainer FindPlaceExplainer(std::string_view type) {
  static const std::map<std::string_view, Explainer> explainers = {
      {"accessible", Accessible},
      {"against_wall", AgainstWall},
      {"away_from_feature", AwayFromFeature},
      {"centered_on_wall", CenteredOnWall},
      {"central", Central},
      {"clear_of_feature", ClearOfFeature},
      {"close_to_feature", CloseToFeature},
      {"faces_feature", FacesFeature},
      {"facing_into_room", FacingIntoRoom},
      {"in_corner", InCorner},
      {"in_zone", InZone},
      {"near_wall", NearWall},
      {"not_against_wall", NotAgainstWall},
      {"not_in_corner", NotInCorner},
      {"parallel_to_wall", ParallelToWall},
      {"under_window", UnderWindow},
  };
  const auto found = explainers.find(type);
  return found == explainers.end() ? nullptr : found->second;
}

}  // namespace flair::optimizer
