// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps an object wholly on another, seen from above.
//   cost = sum over corners of max(|u| - w / 2, 0)^2 + max(|v| - d / 2, 0)^2                                   [m2]
//   u, v  the object's corners in the target's frame;  w, d  the target's width and depth
// Zero exactly when no corner sticks out. The released io_on sums edges of the intersection, so that less contact costs
// less (SEMANTICS.md section 4).
#include <fmt/format.h>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/outside.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

namespace {

struct On {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;
  static constexpr bool kSeesZero = true;
  Footprint object;
  Footprint target;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const {
    return SquaredSticksOut(object, frames[0], target, frames[1]);
  }
};

std::optional<Shortfall> OnShortfall(const PlacedCall& call) {
  const double out = call.CostRoot();
  return Worst(
      {{fmt::format("{} sticks {:.2f} m out over {}", call.NameOf("object"), out, call.NameOf("target")), out, "m"}});
}

}  // namespace

ConstraintFacts OnFacts() {
  return {.name = "on",
          .aliases = {"io_on"},
          .family = "pair",
          .summary = "`object` stands wholly on `target`, seen from above.",
          .phrase = "stands wholly on {target}",
          .doc =
              "cost = squared overhang of the object's four corners over the target's sides [m2]. The released "
              "function counts "
              "edges of the intersection.",
          .parameters = {ObjectParameter("object", "What stands on it."),
                         ObjectParameter("target", "What carries it, such as a rug.")},
          .sentences = {{"The coffee table stands on the rug.", "object=table target=rug"}},
          .layouts = {Satisfied("5x4 room; table 1x0.6 at 2.3,2,20; rug 3x2 at 2,2,0 rug", "object=table target=rug"),
                      Violated("5x4 room; table 1x0.6 at 3.3,2,20; rug 3x2 at 2,2,0 rug", "object=table target=rug")},
          .shortfall = OnShortfall,
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            const int object = a.Object("object");
            const int target = a.Object("target");
            return MakeCost(On{FootprintOf(context, object), FootprintOf(context, target)}, {object, target});
          }};
}

}  // namespace flair::optimizer
