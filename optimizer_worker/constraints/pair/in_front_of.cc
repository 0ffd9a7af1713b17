// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/pair/in_front_of.h"

#include <cmath>

#include "optimizer_worker/autodiff/smooth.h"
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/measure/convex_piece.h"

namespace flair::optimizer {

template <typename T>
T InFrontOf::operator()(const Frames<T, 2>& frames) const {
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

ConstraintFacts InFrontOfFacts() {
  return {
      .name = "in_front_of",
      .aliases = {"io_infront", "p_infront"},
      .family = "pair",
      .summary = "`object` stands before the middle of `target`'s front, `distance_m` away or down to half of it.",
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
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        const int object = a.Object("object");
        const int target = a.Object("target");
        return MakeCost(InFrontOf{FootprintOf(context, object), FootprintOf(context, target), a.Number("distance_m"),
                                  a.Flag("parallel")},
                        {object, target});
      }};
}

}  // namespace flair::optimizer
