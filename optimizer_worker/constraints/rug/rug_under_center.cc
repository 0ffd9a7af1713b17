// SPDX-License-Identifier: GPL-3.0-or-later
// Centres a rug under an object: cost = |c_rug - c_object|^2 [m2], as the released rug_under_central. Zero exactly when
// the centres meet.
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"

namespace flair::optimizer {

namespace {

struct RugUnderCenter {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const {
    return SquaredNorm(frames[0].center - frames[1].center);
  }
};

std::optional<Shortfall> RugUnderCenterShortfall(const PlacedCall& call) {
  return OffMiddle(call, call.arguments().Object("rug"), call.object());
}

}  // namespace

ConstraintFacts RugUnderCenterFacts() {
  return {.name = "rug_under_center",
          .aliases = {"rug_under_central"},
          .family = "rug",
          .summary = "`rug` lies centred under `object`.",
          .phrase = "lies centred under {object}",
          .doc = "cost = squared distance of the centres [m2], as released.",
          .parameters = {ObjectParameter("rug", "The rug."), ObjectParameter("object", "What stands on it.")},
          .sentences = {{"A rug lies under the coffee table.", "rug=rug object=table"}},
          .layouts = {Satisfied("5x4 room; rug 3x2 at 2,2,0 rug; table 1x1 at 2,2,0", "rug=rug object=table"),
                      Violated("5x4 room; rug 3x2 at 2.4,2.1,0 rug; table 1x1 at 2,2,0", "rug=rug object=table")},
          .shortfall = RugUnderCenterShortfall,
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            return MakeCost(RugUnderCenter{}, {a.Object("rug"), a.Object("object")});
          }};
}

}  // namespace flair::optimizer
