// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/pair/perpendicular.h"

#include "optimizer_worker/autodiff/smooth.h"
#include "optimizer_worker/constraints/facts.h"

namespace flair::optimizer {

template <typename T>
T RightAngle::operator()(const Frames<T, 2>& frames) const {
  return Square(Dot(frames[0].front, frames[1].front));
}

namespace {

template <typename T>
T Before(const Footprint& footprint, const Frame<T>& frame, const Vec2<T>& point) {
  const Vec2<T> p = frame.ToObject(point);
  return SquaredOutside(p.x, -footprint.width_m / 4, footprint.width_m / 4) + SquaredHinge(-p.y);
}

}  // namespace

template <typename T>
T PerpendicularAround::operator()(const Frames<T, 3>& frames) const {
  return Square(Dot(frames[0].front, frames[1].front)) + Before(object, frames[0], frames[2].center) +
         Before(target, frames[1], frames[2].center);
}

ConstraintFacts PerpendicularFacts() {
  return {.name = "perpendicular",
          .aliases = {"io_perp", "p_perp"},
          .family = "pair",
          .summary = "`object` and `target` stand at a right angle, both looking at `center` when one is named.",
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
