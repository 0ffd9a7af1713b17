// SPDX-License-Identifier: GPL-3.0-or-later
// Families pair and group: objects among each other.
#include <cmath>
#include <map>

#include "fmt/format.h"
#include "optimizer_worker/constraints/measure/walls.h"
#include "optimizer_worker/explain/scope.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {
namespace {

using Found = std::optional<Shortfall>;

int ObjectOf(const Scope& scope) { return scope.arguments().Object("object"); }
int TargetOf(const Scope& scope) { return scope.arguments().Object("target"); }

Found Near(const Scope& scope) {
  return Worst(
      {TooFar(scope.NameOf("object"), scope.NameOf("target"), scope.GapBetween(ObjectOf(scope), TargetOf(scope)),
              scope.arguments().Number("max_distance_m"))});
}

Found AwayFrom(const Scope& scope) {
  return Worst(
      {TooNear(scope.NameOf("object"), scope.NameOf("target"), scope.GapBetween(ObjectOf(scope), TargetOf(scope)),
               scope.arguments().Number("min_distance_m"))});
}

// How an object misses looking at another: out of its strip, or behind.
Shortfall NotFaced(const Scope& scope, int object, int target) {
  const Frame<double> frame = scope.FrameOf(object);
  const Vec2<double> p = frame.ToObject(scope.FrameOf(target).center);
  const double aside = std::abs(p.x) - scope.FootprintOf(object).width_m / 2;
  if (p.y >= 0 && aside > 0) {
    return {fmt::format("{} is {:.2f} m to the side of where {} looks", scope.Name(target), aside, scope.Name(object)),
            aside, "m"};
  }
  return Turned(SideOf(scope.Name(object), Side::kFront), scope.Name(target),
                p.y >= 0 ? 0 : AngleOf(frame.front, scope.FrameOf(target).center - frame.center));
}

Found Facing(const Scope& scope) {
  const int object = ObjectOf(scope), target = TargetOf(scope);
  std::vector<Shortfall> misses = {NotFaced(scope, object, target)};
  if (scope.arguments().Flag("both")) {
    misses.push_back(NotFaced(scope, target, object));
    misses.push_back(Turned(scope.Name(object), fmt::format("facing {} squarely", scope.Name(target)),
                            kPi - AngleOf(scope.FrameOf(object).front, scope.FrameOf(target).front)));
  }
  return Worst(misses);
}

Found NotFacing(const Scope& scope) {
  const Frame<double> frame = scope.FrameOf(ObjectOf(scope));
  const double angle = AngleOf(frame.front, scope.FrameOf(TargetOf(scope)).center - frame.center);
  const double missed_deg = 45 - angle * 180 / kPi;
  return Worst({{fmt::format("{} looks within {:.0f} degrees of {}, at least 45", scope.NameOf("object"),
                             angle * 180 / kPi, scope.NameOf("target")),
                 missed_deg, "deg"}});
}

Found InFrontOf(const Scope& scope) {
  const int object = ObjectOf(scope), target = TargetOf(scope);
  const Frame<double> frame = scope.FrameOf(target);
  const double most = scope.arguments().Number("distance_m");
  const double lateral = frame.ToObject(scope.FrameOf(object).center).x;
  const double play = std::abs(scope.FootprintOf(object).width_m - scope.FootprintOf(target).width_m) / 4;
  double gap = 1e9;
  for (int i = 0; i < 4; ++i) gap = std::min(gap, frame.ToObject(scope.BoxOf(object).value(i)).y);
  gap -= scope.FootprintOf(target).depth_m / 2;
  const std::string front = SideOf(scope.Name(target), Side::kFront);
  std::vector<Shortfall> misses = {
      TooFar(scope.Name(object), front, gap, most), TooNear(scope.Name(object), front, gap, most / 2),
      OffBy(scope.Name(object), "the middle of " + front, std::max(0.0, std::abs(lateral) - play))};
  if (scope.arguments().Flag("parallel")) {
    const double angle = AngleOf(scope.FrameOf(object).front, frame.front);
    misses.push_back(Turned(scope.Name(object), front, std::min(angle, kPi - angle)));
  }
  return Worst(misses);
}

Found NextTo(const Scope& scope) {
  const int object = ObjectOf(scope), target = TargetOf(scope);
  const double gap = scope.GapBetween(object, target);
  constexpr double kTouching_m = 0.05;
  if (const Found far = Worst({TooFar(scope.Name(object), scope.Name(target), gap, kTouching_m)})) return far;
  return Worst({OffBy(scope.Name(object), fmt::format("its place beside {}", scope.Name(target)), scope.CostRoot())});
}

Found Parallel(const Scope& scope) {
  return Worst({Turned(scope.NameOf("object"), "the direction of " + scope.NameOf("target"),
                       AngleOf(scope.FrameOf(ObjectOf(scope)).front, scope.FrameOf(TargetOf(scope)).front))});
}

Found Perpendicular(const Scope& scope) {
  const double angle = AngleOf(scope.FrameOf(ObjectOf(scope)).front, scope.FrameOf(TargetOf(scope)).front);
  std::vector<Shortfall> misses = {
      Turned(scope.NameOf("object"), "a right angle to " + scope.NameOf("target"), std::abs(angle - kPi / 2))};
  if (scope.arguments().Has("center")) {
    misses.push_back(OffBy(scope.NameOf("object") + " or " + scope.NameOf("target"),
                           "where it would face " + scope.Name(scope.arguments().MaybeObject("center")),
                           scope.CostRoot()));
  }
  return Worst(misses);
}

Found Between(const Scope& scope) {
  return Worst(
      {OffBy(scope.NameOf("object"),
             fmt::format("the way from {} to {}", scope.NameOf("first"), scope.NameOf("second")), scope.CostRoot())});
}

Found On(const Scope& scope) {
  const double out = scope.CostRoot();
  return Worst(
      {{fmt::format("{} sticks {:.2f} m out over {}", scope.NameOf("object"), out, scope.NameOf("target")), out, "m"}});
}

Found UnderCenter(const Scope& scope) {
  const Frame<double> object = scope.FrameOf(ObjectOf(scope)), target = scope.FrameOf(TargetOf(scope));
  const double angle = AngleOf(object.front, target.front);
  return Worst(
      {OffBy(scope.NameOf("object"), "the middle of " + scope.NameOf("target"), Norm(object.center - target.center)),
       Turned(scope.NameOf("object"), "the sides of " + scope.NameOf("target"), std::min(angle, kPi - angle))});
}

Found Surround(const Scope& scope) {
  const std::string center = scope.Name(scope.arguments().Object("center"));
  std::vector<Shortfall> misses;
  for (int seat : scope.arguments().Objects("objects")) {
    const Frame<double> frame = scope.FrameOf(seat);
    const Vec2<double> to_center = scope.FrameOf(scope.arguments().Object("center")).center - frame.center;
    misses.push_back(TooFar(scope.Name(seat), center, scope.GapBetween(seat, scope.arguments().Object("center")), 0.1));
    misses.push_back(Turned(SideOf(scope.Name(seat), Side::kFront), center, AngleOf(frame.front, to_center), kPi / 4));
  }
  if (const Found worst = Worst(misses)) return worst;
  return Worst({OffBy("one of those round " + center, "an even place", scope.CostRoot())});
}

Found Row(const Scope& scope) {
  const std::vector<int>& objects = scope.arguments().Objects("objects");
  return Worst(
      {OffBy(fmt::format("one of {} and its neighbours", scope.Name(objects[0])), "one flush row", scope.CostRoot())});
}

}  // namespace

Explainer FindPairExplainer(std::string_view type) {
  static const std::map<std::string_view, Explainer> explainers = {
      {"away_from", AwayFrom},          {"between", Between}, {"facing", Facing},
      {"in_front_of", InFrontOf},       {"near", Near},       {"next_to", NextTo},
      {"not_facing", NotFacing},        {"on", On},           {"parallel", Parallel},
      {"perpendicular", Perpendicular}, {"row", Row},         {"surround", Surround},
      {"under_center", UnderCenter},
  };
  const auto found = explainers.find(type);
  return found == explainers.end() ? nullptr : found->second;
}

}  // namespace flair::optimizer
