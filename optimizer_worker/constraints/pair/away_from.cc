// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/pair/away_from.h"

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/measure/gap.h"

namespace flair::optimizer {

template <typename T>
T AwayFrom::operator()(const Frames<T, 2>& frames) const {
  // Far apart by their circles already.
  if (SquaredNorm(ValueOf(frames[0].center) - ValueOf(frames[1].center)) >= reach_m * reach_m) return T(0.0);
  return SquaredNearness<T>(Box<T>(object, frames[0]), Box<T>(target, frames[1]), min_distance_m);
}

ConstraintFacts AwayFromFacts() {
  return {
      .name = "away_from",
      .aliases = {"io_away_from", "p_away_from", "ind_away_from", "io_min_dist"},
      .family = "pair",
      .summary = "`object` and `target` are at least `min_distance_m` apart.",
      .doc =
          "cost = max(min_distance_m - gap between the two rectangles, 0)^2 [m2]. The released function is never zero.",
      .parameters = {ObjectParameter("object", "What keeps away."), ObjectParameter("target", "From what."),
                     LengthParameter("min_distance_m", "Smallest gap.", 0, 50, 2)},
      .sentences = {{"The desk is away from the bed.", "object=desk target=bed"},
                    {"The treadmill is at least a metre from the shelf.",
                     "object=treadmill target=shelf min_distance_m=1"}},
      .layouts = {Satisfied("8x4 room; a 1x1 at 1,1,0; b 1x1 at 4.5,1,0", "object=a target=b"),
                  Violated("8x4 room; a 1x1 at 1,1,0; b 1x1 at 3,1.3,20", "object=a target=b"),
                  Violated("8x4 room; a 1x1 at 1,1,0; b 1x1 at 1.4,1.3,20", "object=a target=b")},
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        const int object = a.Object("object");
        const int target = a.Object("target");
        return MakeCost(
            AwayFrom{FootprintOf(context, object), FootprintOf(context, target), a.Number("min_distance_m")},
            {object, target});
      }};
}

}  // namespace flair::optimizer
