// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps two objects apart: cost = max(min - gap, 0)^2 [m2], gap the signed gap between the two rectangles.
// Zero exactly when they are at least min_distance_m apart. The released io_away_from is exp(min - centre distance),
// never zero (SEMANTICS.md section 4).
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/gap.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

namespace {

struct AwayFrom {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;
  static constexpr bool kSeesZero = true;
  Footprint object;
  Footprint target;
  double min_distance_m;
  // Their centres are at least this far apart: nothing to do.
  double reach_m = min_distance_m + CircumscribedRadius(object) + CircumscribedRadius(target);

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const {
    // Far apart by their circles already.
    if (SquaredNorm(ValueOf(frames[0].center) - ValueOf(frames[1].center)) >= reach_m * reach_m) return T(0.0);
    return SquaredNearness<T>(Box<T>(object, frames[0]), Box<T>(target, frames[1]), min_distance_m);
  }
};

std::optional<Shortfall> AwayFromShortfall(const PlacedCall& call) {
  return Worst({TooNear(call.NameOf("object"), call.NameOf("target"), call.GapBetween(call.object(), call.target()),
                        call.arguments().Number("min_distance_m"))});
}

}  // namespace

ConstraintFacts AwayFromFacts() {
  return {
      .name = "away_from",
      .aliases = {"io_away_from", "p_away_from", "ind_away_from", "io_min_dist"},
      .family = "pair",
      .summary = "`object` and `target` are at least `min_distance_m` apart.",
      .phrase = "keeps at least {min_distance_m} from {target}",
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
      .shortfall = AwayFromShortfall,
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        const int object = a.Object("object");
        const int target = a.Object("target");
        return MakeCost(
            AwayFrom{FootprintOf(context, object), FootprintOf(context, target), a.Number("min_distance_m")},
            {object, target});
      }};
}

}  // namespace flair::optimizer
