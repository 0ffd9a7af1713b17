// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps two objects near each other: cost = max(gap - max, 0)^2 [m2], gap the distance between the two rectangles.
// Zero exactly when they are at most max_distance_m apart. The released io_near measures from centre to centre
// (SEMANTICS.md section 4).
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/gap.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

namespace {

struct Near {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;
  static constexpr bool kSeesZero = true;
  Footprint object;
  Footprint target;
  double max_distance_m;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const {
    // The gap is less than the distance of the centres.
    if (SquaredNorm(ValueOf(frames[0].center) - ValueOf(frames[1].center)) <= max_distance_m * max_distance_m)
      return T(0.0);
    return SquaredDistanceBeyond<T>(Box<T>(object, frames[0]), Box<T>(target, frames[1]), max_distance_m);
  }
};

std::optional<Shortfall> NearShortfall(const PlacedCall& call) {
  return Worst({TooFar(call.NameOf("object"), call.NameOf("target"), call.GapBetween(call.object(), call.target()),
                       call.arguments().Number("max_distance_m"))});
}

}  // namespace

ConstraintFacts NearFacts() {
  return {.name = "near",
          .aliases = {"io_near", "p_near"},
          .family = "pair",
          .summary = "`object` and `target` are at most `max_distance_m` apart.",
          .phrase = "is at most {max_distance_m} from {target}",
          .doc =
              "cost = max(gap between the two rectangles - max_distance_m, 0)^2 [m2]. The released function measures "
              "centres.",
          .parameters = {ObjectParameter("object", "What is near."), ObjectParameter("target", "To what."),
                         LengthParameter("max_distance_m", "Largest gap.", 0, 50, 3)},
          .sentences = {{"The armchair is near the bookshelf.", "object=armchair target=bookshelf"},
                        {"The coffee table is within half a metre of the sofa.",
                         "object=table target=sofa max_distance_m=0.5"}},
          .layouts = {Satisfied("8x4 room; a 1x1 at 1,1,0; b 1x1 at 4.5,1,0", "object=a target=b"),
                      Violated("8x4 room; a 1x1 at 1,1,0; b 1x1 at 6,1.3,20", "object=a target=b")},
          .shortfall = NearShortfall,
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            const int object = a.Object("object");
            const int target = a.Object("target");
            return MakeCost(
                Near{FootprintOf(context, object), FootprintOf(context, target), a.Number("max_distance_m")},
                {object, target});
          }};
}

}  // namespace flair::optimizer
