// SPDX-License-Identifier: GPL-3.0-or-later
// Hangs an object above another: cost = |c1 - c2|^2 [m2], as the released ceiling_above. Zero exactly when the centres
// meet.
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"

namespace flair::optimizer {

namespace {

struct CeilingAbove {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const {
    return SquaredNorm(frames[0].center - frames[1].center);
  }
};

std::optional<Shortfall> CeilingAboveShortfall(const PlacedCall& call) {
  return OffMiddle(call, call.object(), call.target());
}

}  // namespace

ConstraintFacts CeilingAboveFacts() {
  return {
      .name = "ceiling_above",
      .family = "ceiling",
      .summary = "`object` hangs from the ceiling above the middle of `target`.",
      .phrase = "hangs above the middle of {target}",
      .doc = "cost = squared distance of the centres [m2], as released.",
      .parameters = {ObjectParameter("object", "What hangs."), ObjectParameter("target", "What it hangs above.")},
      .sentences = {{"A pendant lamp hangs above the dining table.", "object=lamp target=table"}},
      .layouts = {Satisfied("5x4 room; lamp 0.5x0.5 at 2,2,0 ceiling; table 1x1 at 2,2,40", "object=lamp target=table"),
                  Violated("5x4 room; lamp 0.5x0.5 at 2.2,2.4,0 ceiling; table 1x1 at 2,2,40",
                           "object=lamp target=table")},
      .shortfall = CeilingAboveShortfall,
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        return MakeCost(CeilingAbove{}, {a.Object("object"), a.Object("target")});
      }};
}

}  // namespace flair::optimizer
