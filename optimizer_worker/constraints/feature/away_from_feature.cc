// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps an object away from all doors, windows or sockets.
//   cost = sum over features of that kind of  max(min - gap, 0)^2                                            [m2]
//   gap  signed gap between the rectangle and the feature's interval on the wall
// Zero exactly when every one is at least min_distance_m away. The released ind_away_from_fixed_object measures from
// centre to hinge less half a diagonal (SEMANTICS.md section 3).
#include <vector>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/convex_piece.h"
#include "optimizer_worker/constraints/measure/gap.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

namespace {

struct AwayFromFeature {
  static constexpr int kObjects = 1;
  static constexpr bool kSeesZero = true;
  Footprint footprint;
  double min_distance_m;
  std::vector<ConvexPiece> features;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const {
    const Box<T> box(footprint, frames[0]);
    T sum(0.0);
    for (const ConvexPiece& feature : features) sum += SquaredNearness<T>(box, feature, min_distance_m);
    return sum;
  }
};

std::optional<Shortfall> AwayFromFeatureShortfall(const PlacedCall& call) {
  return Worst({TooNear(call.NameOf("object"), call.FeatureName(), call.NearestFeatureGap(),
                        call.arguments().Number("min_distance_m"))});
}

}  // namespace

ConstraintFacts AwayFromFeatureFacts() {
  return {
      .name = "away_from_feature",
      .aliases = {"ind_away_from_fixed_object", "io_away_from_fixed_object"},
      .family = "feature",
      .summary = "`object` is at least `min_distance_m` from every door, window or socket.",
      .phrase = "keeps at least {min_distance_m} from every {feature}",
      .doc =
          "cost = sum over features of max(min_distance_m - gap, 0)^2 [m2], rectangle to the feature's interval. The "
          "released function measures from centre to hinge.",
      .parameters = {ObjectParameter("object", "What is kept away."), FeatureParameter("feature", "From what."),
                     LengthParameter("min_distance_m", "Smallest distance.", 0, 20, 2)},
      .sentences = {{"The bed is away from the door.", "object=bed feature=door"},
                    {"The bookshelf is at least a metre from the window.",
                     "object=bookshelf feature=window min_distance_m=1"}},
      .layouts = {Satisfied("6x4 room; door south 0.2 0.9; bed 1.6x2 at 4.5,1,0", "object=bed feature=door"),
                  Violated("6x4 room; door south 0.2 0.9; bed 1.6x2 at 3,1.3,20", "object=bed feature=door")},
      .shortfall = AwayFromFeatureShortfall,
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        const int object = a.Object("object");
        AwayFromFeature formula{FootprintOf(context, object), a.Number("min_distance_m"), {}};
        for (const Segment& s : FeatureSegments(context.scene.room, a.Feature("feature")))
          formula.features.emplace_back(s);
        return MakeCost(std::move(formula), {object});
      }};
}

}  // namespace flair::optimizer
