// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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

namespace flair::optimizer {
namespace {

// Keeps two objects apart: cost = max(min - gap, 0)^2 [m2], gap the signed gap between the two rectangles.
// Zero exactly when they are at least min_distance_m apart. The released io_away_from is exp(min - centre distance),
// never zero (SEMANTICS.md section 4).
std::optional<Shortfall> AwayFromShortfall(const PlacedCall& call) {
  return Worst({TooNear(call.NameOf("object"), call.NameOf("target"), call.GapBetween(call.object(), call.target()),
                        call.arguments().Number("min_distance_m"))});
}

BoundCost BindAwayFrom(const Arguments& a, const BindContext& context) {
  const int object = a.Object("object"), target = a.Object("target");
  const Footprint first = FootprintOf(context, object), second = FootprintOf(context, target);
  const double min_m = a.Number("min_distance_m");
  // Their centres are at least this far apart: nothing to do.
  const double reach_m = min_m + CircumscribedRadius(first) + CircumscribedRadius(second);
  return MakeCost<kOnlyRelative | kSeesZero>({object, target}, [=]<typename T>(const Frames<T, 2>& frames) {
    if (SquaredNorm(ValueOf(frames[0].center) - ValueOf(frames[1].center)) >= reach_m * reach_m) return T(0.0);
    return SquaredNearness<T>(Box<T>(first, frames[0]), Box<T>(second, frames[1]), min_m);
  });
}

// Puts an object between two others.
//   cost = max(|lateral| - play, 0)^2 + max(-s_1, 0)^2 + max(-s_2, 0)^2                                        [m2]
//   lateral  distance of its centre from the line through the centres of the two;  play  a quarter of its shorter side
//   s_1, s_2 how far its centre is from either, along that line, less a quarter of the line or half its shorter side
// Zero exactly when its centre lies over the middle half of the way from one to the other. The released io_between asks
// it to touch both, with all three facing the same way (SEMANTICS.md section 4).
std::optional<Shortfall> BetweenShortfall(const PlacedCall& call) {
  return Worst(
      {OffBy(call.NameOf("object"), fmt::format("the way from {} to {}", call.NameOf("first"), call.NameOf("second")),
             call.CostRoot())});
}

BoundCost BindBetween(const Arguments& a, const BindContext& context) {
  const int object = a.Object("object");
  const Footprint& footprint = FootprintOf(context, object);
  const double shorter = std::min(footprint.width_m, footprint.depth_m);
  const auto formula = [shorter]<typename T>(const Frames<T, 3>& frames) {
    const Vec2<T> way = frames[2].center - frames[1].center;
    const Vec2<T> from_first = frames[0].center - frames[1].center;
    const T length = Length(way);
    constexpr double kNoWay_m = 1e-4;
    // Two in one place: there is nothing between them; near them is nearest.
    if (ValueOf(length) < kNoWay_m) return SquaredNorm(from_first) + T(shorter * shorter / 4);
    const T along = Dot(from_first, way) / length;
    const T lateral = Cross(way, from_first) / length;
    const T margin = ValueOf(length) > 2 * shorter ? length / 4 : T(shorter / 2);
    return SquaredOutside(lateral, -shorter / 4, shorter / 4) + SquaredHinge(margin - along) +
           SquaredHinge(along - length + margin);
  };
  return MakeCost<kOnlyRelative>({object, a.Object("first"), a.Object("second")}, formula);
}

// Puts an object in front of another.
//   cost = out(gap, [distance / 2, distance])^2 + max(|u| - play, 0)^2 + [parallel] sin^2(theta_1 - theta_2)    [m2]
//   gap   air between the target's front and the nearest corner of the object, along the target's front direction
//   u     lateral offset of the object's centre from the target's middle line
//   play  a quarter of what the narrower can move within the wider, |w_1 - w_2| / 8
// Zero exactly when the object stands before the target's middle, at distance_m or down to min_distance_m, half of it
// when left out, square to it (a half turn is the same). The released io_infront asks for one point, counts a side
// shift like a distance and jumps where headings wrap (SEMANTICS.md section 4).
double LeastBefore(const Arguments& a) {
  return std::min(a.NumberOr("min_distance_m", a.Number("distance_m") / 2), a.Number("distance_m"));
}

std::optional<Shortfall> InFrontOfShortfall(const PlacedCall& call) {
  const int object = call.object(), target = call.target();
  const Frame<double> frame = call.FrameOf(target);
  const double most = call.arguments().Number("distance_m");
  const double lateral = frame.ToObject(call.FrameOf(object).center).x;
  const double play = std::abs(call.FootprintOf(object).width_m - call.FootprintOf(target).width_m) / 8;
  double gap = 1e9;
  for (int i = 0; i < 4; ++i) gap = std::min(gap, frame.ToObject(call.BoxOf(object).value(i)).y);
  gap -= call.FootprintOf(target).depth_m / 2;
  const std::string front = SideOf(call.Name(target), Side::kFront);
  std::vector<Shortfall> misses = {
      TooFar(call.Name(object), front, gap, most),
      TooNear(call.Name(object), front, gap, LeastBefore(call.arguments())),
      OffBy(call.Name(object), "the middle of " + front, std::max(0.0, std::abs(lateral) - play))};
  if (call.arguments().Flag("parallel")) {
    const double angle = AngleOf(call.FrameOf(object).front, frame.front);
    misses.push_back(Turned(call.Name(object), front, std::min(angle, kPi - angle)));
  }
  return Worst(misses);
}

BoundCost BindInFrontOf(const Arguments& a, const BindContext& context) {
  const int object = a.Object("object"), target = a.Object("target");
  const Footprint first = FootprintOf(context, object), second = FootprintOf(context, target);
  const auto formula = [=, distance_m = a.Number("distance_m"), least_m = LeastBefore(a),
                        parallel = a.Flag("parallel")]<typename T>(const Frames<T, 2>& frames) {
    const Box<T> box(first, frames[0]);
    const Frame<double> target_value = ValueOf(frames[1]);
    int nearest = 0;
    for (int i = 1; i < box.count(); ++i) {
      if (target_value.ToObject(box.value(i)).y < target_value.ToObject(box.value(nearest)).y) nearest = i;
    }
    const T gap = frames[1].ToObject(box.vertex(nearest)).y - second.depth_m / 2;
    const T lateral = frames[1].ToObject(frames[0].center).x;
    const double play = std::abs(first.width_m - second.width_m) / 8;
    T sum = SquaredOutside(gap, least_m, distance_m) + SquaredOutside(lateral, -play, play);
    if (parallel) sum += Square(Cross(frames[0].front, frames[1].front));
    return sum;
  };
  return MakeCost<kOnlyRelative>({object, target}, formula);
}

// Keeps two objects near each other: cost = max(gap - max, 0)^2 [m2], gap the distance between the two rectangles.
// Zero exactly when they are at most max_distance_m apart. The released io_near measures from centre to centre
// (SEMANTICS.md section 4).
std::optional<Shortfall> NearShortfall(const PlacedCall& call) {
  return Worst({TooFar(call.NameOf("object"), call.NameOf("target"), call.GapBetween(call.object(), call.target()),
                       call.arguments().Number("max_distance_m"))});
}

BoundCost BindNear(const Arguments& a, const BindContext& context) {
  const int object = a.Object("object"), target = a.Object("target");
  const Footprint first = FootprintOf(context, object), second = FootprintOf(context, target);
  const double max_m = a.Number("max_distance_m");
  const auto formula = [=]<typename T>(const Frames<T, 2>& frames) {
    // The gap is less than the distance of the centres.
    if (SquaredNorm(ValueOf(frames[0].center) - ValueOf(frames[1].center)) <= max_m * max_m) return T(0.0);
    return SquaredDistanceBeyond<T>(Box<T>(first, frames[0]), Box<T>(second, frames[1]), max_m);
  };
  return MakeCost<kOnlyRelative | kSeesZero>({object, target}, formula);
}

// Puts a side of one object next to a side of another.
//   cost = min over allowed pairs of sides of  gap^2 + overhang^2 + (1 + n1 . n2)                  [m2]
//   gap       distance of the object's side's middle along the target side's outward normal, beyond [0, kSlack]
//   overhang  how far the shorter side sticks out beyond the longer, max(|along| - |L1 - L2| / 2, 0)
//   n1, n2    outward normals of the two sides; opposed when the sides meet
// Zero exactly when the sides meet (up to 5 cm of air), parallel, the shorter within the longer. Sides left out may be
// any. The released io_next_to mixes metres and fractions and is right only for sides of 1 m (SEMANTICS.md section 4).

// Air that still counts as next to.
inline constexpr double kNextToSlack_m = 0.05;

// The cost of one pair of sides.
template <typename T>
T SidesMeet(const Footprint& first, const Frame<T>& first_frame, Side first_side, const Footprint& second,
            const Frame<T>& second_frame, Side second_side) {
  const Vec2<T> n1 = NormalOf(first_frame, first_side);
  const Vec2<T> n2 = NormalOf(second_frame, second_side);
  const Vec2<T> between = MiddleOf(first, first_frame, first_side) - MiddleOf(second, second_frame, second_side);
  const double play = std::abs(SideLength(first, first_side) - SideLength(second, second_side)) / 2;
  return SquaredOutside(Dot(between, n2), 0, kNextToSlack_m) + SquaredOutside(Cross(n2, between), -play, play) +
         (T(1.0) + Dot(n1, n2));
}

std::vector<Side> SidesOrAll(const std::optional<Side>& side) {
  if (side.has_value()) return {*side};
  return {kSides.begin(), kSides.end()};
}

BoundCost BindNextTo(const Arguments& a, const BindContext& context) {
  const int object = a.Object("object"), target = a.Object("target");
  // Side of the object, side of the target.
  std::vector<std::pair<Side, Side>> ways;
  for (Side first : SidesOrAll(a.MaybeSide("object_side"))) {
    for (Side second : SidesOrAll(a.MaybeSide("target_side"))) ways.emplace_back(first, second);
  }
  const auto formula = [ways, first = FootprintOf(context, object),
                        second = FootprintOf(context, target)]<typename T>(const Frames<T, 2>& frames) {
    return LeastOf<T>(ways, frames, [&](const std::pair<Side, Side>& way, const auto& f) {
      return SidesMeet(first, f[0], way.first, second, f[1], way.second);
    });
  };
  return MakeCost<kOnlyRelative | kSeesZero>({object, target}, formula);
}

std::optional<Shortfall> NextToShortfall(const PlacedCall& call) {
  const int object = call.object(), target = call.target();
  const double gap = call.GapBetween(object, target);
  constexpr double kTouching_m = 0.05;
  if (const std::optional<Shortfall> far = Worst({TooFar(call.Name(object), call.Name(target), gap, kTouching_m)}))
    return far;
  return Worst({OffBy(call.Name(object), fmt::format("its place beside {}", call.Name(target)), call.CostRoot())});
}

constexpr ConstraintCode kPlacesCode[] = {
    {"away_from", BindAwayFrom, AwayFromShortfall},     {"between", BindBetween, BetweenShortfall},
    {"in_front_of", BindInFrontOf, InFrontOfShortfall}, {"near", BindNear, NearShortfall},
    {"next_to", BindNextTo, NextToShortfall},
};

}  // namespace

std::span<const ConstraintCode> PlacesCode() { return kPlacesCode; }

}  // namespace flair::optimizer
