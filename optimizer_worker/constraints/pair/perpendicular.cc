// SPDX-License-Identifier: GPL-3.0-or-later
// Stands two objects at a right angle, with a third object before both when one is named.
//   cost = (f1 . f2)^2 + sum over both of  max(|u_i| - w_i / 4, 0)^2 + max(-v_i, 0)^2                          [m2]
//   f1, f2    front directions;  u_i, v_i  how far right and ahead of object i the centre object is;  w_i  its width
// The sum is there with `center` only. Zero exactly when they stand at a right angle and the centre object is ahead of
// the middle half of both. The released io_perp drops object 0, reads the pose of another object and divides by zero
// for parallel ones (SEMANTICS.md section 4).
#include <cmath>

#include "optimizer_worker/autodiff/smooth.h"
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/footprint.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {

namespace {

struct RightAngle {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const {
    return Square(Dot(frames[0].front, frames[1].front));
  }
};

template <typename T>
T Before(const Footprint& footprint, const Frame<T>& frame, const Vec2<T>& point) {
  const Vec2<T> p = frame.ToObject(point);
  return SquaredOutside(p.x, -footprint.width_m / 4, footprint.width_m / 4) + SquaredHinge(-p.y);
}

struct PerpendicularAround {
  static constexpr int kObjects = 3;
  static constexpr bool kOnlyRelative = true;
  Footprint object;
  Footprint target;

  template <typename T>
  T operator()(const Frames<T, 3>& frames) const {
    return Square(Dot(frames[0].front, frames[1].front)) + Before(object, frames[0], frames[2].center) +
           Before(target, frames[1], frames[2].center);
  }
};

std::optional<Shortfall> PerpendicularShortfall(const PlacedCall& call) {
  const double angle = AngleOf(call.FrameOf(call.object()).front, call.FrameOf(call.target()).front);
  std::vector<Shortfall> misses = {
      Turned(call.NameOf("object"), "a right angle to " + call.NameOf("target"), std::abs(angle - kPi / 2))};
  if (call.arguments().Has("center")) {
    misses.push_back(OffBy(call.NameOf("object") + " or " + call.NameOf("target"),
                           "where it would face " + call.Name(call.arguments().MaybeObject("center")),
                           call.CostRoot()));
  }
  return Worst(misses);
}

}  // namespace

ConstraintFacts PerpendicularFacts() {
  return {.name = "perpendicular",
          .aliases = {"io_perp", "p_perp"},
          .family = "pair",
          .summary = "`object` and `target` stand at a right angle, both looking at `center` when one is named.",
          .phrase = "stands at a right angle to {target}",
          .doc =
              "cost = squared cosine between the fronts; with center also squared lateral offsets beyond the middle "
              "half of "
              "each and squared distances behind [m2]. The released function reads the wrong object.",
          .parameters = {ObjectParameter("object", "The one."), ObjectParameter("target", "The other."),
                         OptionalObject("center", "What both look at.")},
          .sentences = {{"The armchair is at a right angle to the sofa, both facing the coffee table.",
                         "object=armchair target=sofa center=table"}},
          .layouts = {Satisfied("5x4 room; a 1x1 at 1,1,0; b 1x1 at 3,2,90", "object=a target=b"),
                      Satisfied("5x4 room; a 1x1 at 1,1,0; b 1x1 at 3,2.5,90; c 1x1 at 1,2.5,0",
                                "object=a target=b center=c"),
                      Violated("5x4 room; a 1x1 at 1,1,0; b 1x1 at 3,2,50", "object=a target=b"),
                      Violated("5x4 room; a 1x1 at 1,1,0; b 1x1 at 3,2,95; c 1x1 at 2,0.2,0",
                               "object=a target=b center=c")},
          .shortfall = PerpendicularShortfall,
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            const int object = a.Object("object");
            const int target = a.Object("target");
            const int center = a.MaybeObject("center");
            if (center < 0) return MakeCost(RightAngle{}, {object, target});
            return MakeCost(PerpendicularAround{FootprintOf(context, object), FootprintOf(context, target)},
                            {object, target, center});
          }};
}

}  // namespace flair::optimizer
