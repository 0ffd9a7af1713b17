// SPDX-License-Identifier: GPL-3.0-or-later
// Puts an object in front of another.
//   cost = out(gap, [distance / 2, distance])^2 + max(|u| - play, 0)^2 + [parallel] sin^2(theta_1 - theta_2)    [m2]
//   gap   air between the target's front and the nearest corner of the object, along the target's front direction
//   u     lateral offset of the object's centre from the target's middle line
//   play  half of what the narrower can move within the wider, |w_1 - w_2| / 4
// Zero exactly when the object stands before the target's middle, at distance_m or down to half of it, square to it (a
// half turn is the same). The released io_infront asks for one point, counts a side shift like a distance and jumps
// where headings wrap (SEMANTICS.md section 4).
#include <cmath>

#include "optimizer_worker/autodiff/smooth.h"
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/convex_piece.h"
#include "room/geometry/footprint.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {

namespace {

struct InFrontOf {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;
  Footprint object;
  Footprint target;
  double distance_m;
  bool parallel;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const {
    const Box<T> box(object, frames[0]);
    const Frame<double> target_value = ValueOf(frames[1]);
    int nearest = 0;
    for (int i = 1; i < box.count(); ++i) {
      if (target_value.ToObject(box.value(i)).y < target_value.ToObject(box.value(nearest)).y) nearest = i;
    }
    const T gap = frames[1].ToObject(box.vertex(nearest)).y - target.depth_m / 2;
    const T lateral = frames[1].ToObject(frames[0].center).x;
    const double play = std::abs(object.width_m - target.width_m) / 4;
    T sum = SquaredOutside(gap, distance_m / 2, distance_m) + SquaredOutside(lateral, -play, play);
    if (parallel) sum += Square(Cross(frames[0].front, frames[1].front));
    return sum;
  }
};

std::optional<Shortfall> InFrontOfShortfall(const PlacedCall& call) {
  const int object = call.object(), target = call.target();
  const Frame<double> frame = call.FrameOf(target);
  const double most = call.arguments().Number("distance_m");
  const double lateral = frame.ToObject(call.FrameOf(object).center).x;
  const double play = std::abs(call.FootprintOf(object).width_m - call.FootprintOf(target).width_m) / 4;
  double gap = 1e9;
  for (int i = 0; i < 4; ++i) gap = std::min(gap, frame.ToObject(call.BoxOf(object).value(i)).y);
  gap -= call.FootprintOf(target).depth_m / 2;
  const std::string front = SideOf(call.Name(target), Side::kFront);
  std::vector<Shortfall> misses = {
      TooFar(call.Name(object), front, gap, most), TooNear(call.Name(object), front, gap, most / 2),
      OffBy(call.Name(object), "the middle of " + front, std::max(0.0, std::abs(lateral) - play))};
  if (call.arguments().Flag("parallel")) {
    const double angle = AngleOf(call.FrameOf(object).front, frame.front);
    misses.push_back(Turned(call.Name(object), front, std::min(angle, kPi - angle)));
  }
  return Worst(misses);
}

}  // namespace

ConstraintFacts InFrontOfFacts() {
  return {
      .name = "in_front_of",
      .aliases = {"io_infront", "p_infront"},
      .family = "pair",
      .summary = "`object` stands before the middle of `target`'s front, `distance_m` away or down to half of it.",
      .phrase = "stands before {target}, at most {distance_m} away",
      .doc =
          "cost = squared excess of the gap over [distance_m / 2, distance_m] + squared lateral offset beyond the play "
          "+ "
          "sin^2 of the difference of headings with parallel [m2]. The released function asks for one point.",
      .parameters = {ObjectParameter("object", "What stands in front."), ObjectParameter("target", "Of what."),
                     LengthParameter("distance_m", "Largest gap between the two; the smallest is half of it.", 0, 20,
                                     0.8),
                     FlagParameter("parallel", "Whether their sides are parallel.", true)},
      .sentences = {{"The coffee table is in front of the sofa.", "object=table target=sofa distance_m=0.45"},
                    {"The chair is in front of the desk.", "object=chair target=desk distance_m=0.2 parallel=false"}},
      .layouts = {Satisfied("5x4 room; table 1x0.6 at 2.1,2.1,0; sofa 2x1 at 2,1,0",
                            "object=table target=sofa distance_m=0.4"),
                  Satisfied("5x4 room; table 1x0.6 at 2,2.1,180; sofa 2x1 at 2,1,0",
                            "object=table target=sofa"
                            " distance_m=0.4 parallel=true"),
                  Violated("5x4 room; table 1x0.6 at 2,2.6,10; sofa 2x1 at 2,1,0",
                           "object=table target=sofa distance_m=0.4"),
                  Violated("5x4 room; table 1x0.6 at 3.2,1.9,5; sofa 2x1 at 2,1,0",
                           "object=table target=sofa distance_m=0.4"),
                  Violated("5x4 room; table 1x0.6 at 2,0.1,5; sofa 2x1 at 2,2,0", "object=table target=sofa")},
      .shortfall = InFrontOfShortfall,
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        const int object = a.Object("object");
        const int target = a.Object("target");
        return MakeCost(InFrontOf{FootprintOf(context, object), FootprintOf(context, target), a.Number("distance_m"),
                                  a.Flag("parallel")},
                        {object, target});
      }};
}

}  // namespace flair::optimizer
