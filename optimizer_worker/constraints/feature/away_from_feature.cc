// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/feature/away_from_feature.h"

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/measure/gap.h"

namespace flair::optimizer {

template <typename T>
T AwayFromFeature::operator()(const Frames<T, 1>& frames) const {
  const Box<T> box(footprint, frames[0]);
  T sum(0.0);
  for (const ConvexPiece& feature : features) sum += SquaredNearness<T>(box, feature, min_distance_m);
  return sum;
}

ConstraintFacts AwayFromFeatureFacts() {
  return {
      .name = "away_from_feature",
      .aliases = {"ind_away_from_fixed_object", "io_away_from_fixed_object"},
      .family = "feature",
      .summary = "`object` is at least `min_distance_m` from every door, window or socket.",
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
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        const int object = a.Object("object");
        AwayFromFeature formula{FootprintOf(context, object), a.Number("min_distance_m"), {}};
        for (const Segment& s : FeatureSegments(context.scene.room, a.Feature("feature")))
          formula.features.emplace_back(s);
        return MakeCost(std::move(formula), {object});
      }};
}

}  // namespace flair::optimizer
