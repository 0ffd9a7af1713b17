// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps an object, or one of its sides, close to a door, window or socket.
//   cost = min over features of that kind of  max(d - max, 0)^2                                              [m2]
//   d  distance between the rectangle (or the side) and the feature's interval on the wall
// Zero exactly when some feature is within max_distance_m. The released ind_close_to_fixed_object measures to a door's
// hinge and does not square the excess (SEMANTICS.md section 3).
#include <optional>
#include <vector>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "optimizer_worker/constraints/measure/convex_piece.h"
#include "optimizer_worker/constraints/measure/gap.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

namespace {

struct CloseToFeature {
  static constexpr int kObjects = 1;
  static constexpr bool kSeesZero = true;
  Footprint footprint;
  std::optional<Side> side;
  double max_distance_m;
  std::vector<ConvexPiece> features;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const {
    return LeastOf<T>(features, frames, [this](const ConvexPiece& feature, const auto& f) {
      using S = std::decay_t<decltype(f[0].center.x)>;
      if (!side.has_value()) return SquaredDistanceBeyond<S>(Box<S>(footprint, f[0]), feature, max_distance_m);
      return SquaredDistanceBeyond<S>(Box<S>::Before(footprint, f[0], *side, 0), feature, max_distance_m);
    });
  }
};

std::optional<Shortfall> CloseToFeatureShortfall(const PlacedCall& call) {
  return Worst({TooFar(call.NameOf("object"), call.FeatureName(), call.NearestFeatureGap(),
                       call.arguments().Number("max_distance_m"))});
}

}  // namespace

ConstraintFacts CloseToFeatureFacts() {
  return {
      .name = "close_to_feature",
      .aliases = {"ind_close_to_fixed_object", "io_close_to_fixed_object", "ind_near_fixed_object"},
      .family = "feature",
      .summary = "`object` (or its given side) is within `max_distance_m` of a door, window or socket.",
      .phrase = "is within {max_distance_m} of a {feature}",
      .doc =
          "cost = min over features of max(distance - max_distance_m, 0)^2 [m2], rectangle or side to the feature's "
          "interval. The released function measures to the hinge of a door.",
      .parameters = {ObjectParameter("object", "What is close."), FeatureParameter("feature", "To what."),
                     OptionalSide("side", "Only this side counts; the whole object when left out."),
                     LengthParameter("max_distance_m", "Largest distance.", 0, 20, 0.5)},
      .sentences = {{"The desk is close to a window.", "object=desk feature=window"},
                    {"The lamp is near a socket.", "object=lamp feature=socket"},
                    {"The coat rack is within a metre of the door.", "object=rack feature=door max_distance_m=1"}},
      .layouts = {Satisfied("4x3 room; window south 1 1; desk 1.2x0.6 at 2.9,0.5,0", "object=desk feature=window"),
                  Violated("4x3 room; window south 1 1; desk 1.2x0.6 at 3.2,1.0,5", "object=desk feature=window"),
                  Violated("4x3 room; socket south 1; desk 1.2x0.6 at 1,1.2,0",
                           "object=desk feature=socket side=front max_distance_m=0.8")},
      .shortfall = CloseToFeatureShortfall,
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        const int object = a.Object("object");
        CloseToFeature formula{FootprintOf(context, object), a.MaybeSide("side"), a.Number("max_distance_m"), {}};
        for (const Segment& s : FeatureSegments(context.scene.room, a.Feature("feature")))
          formula.features.emplace_back(s);
        return MakeCost(std::move(formula), {object});
      }};
}

}  // namespace flair::optimizer
