// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/pair/on.h"

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/measure/on_top.h"

namespace flair::optimizer {

template <typename T>
T On::operator()(const Frames<T, 2>& frames) const {
  return SquaredSticksOut(object, frames[0], target, frames[1]);
}

ConstraintFacts OnFacts() {
  return {.name = "on",
          .aliases = {"io_on"},
          .family = "pair",
          .summary = "`object` stands wholly on `target`, seen from above.",
          .doc =
              "cost = squared overhang of the object's four corners over the target's sides [m2]. The released "
              "function counts "
              "edges of the intersection.",
          .parameters = {ObjectParameter("object", "What stands on it."),
                         ObjectParameter("target", "What carries it, such as a rug.")},
          .sentences = {{"The coffee table stands on the rug.", "object=table target=rug"}},
          .layouts = {Satisfied("5x4 room; table 1x0.6 at 2.3,2,20; rug 3x2 at 2,2,0 rug", "object=table target=rug"),
                      Violated("5x4 room; table 1x0.6 at 3.3,2,20; rug 3x2 at 2,2,0 rug", "object=table target=rug")},
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            const int object = a.Object("object");
            const int target = a.Object("target");
            return MakeCost(On{FootprintOf(context, object), FootprintOf(context, target)}, {object, target});
          }};
}

}  // namespace flair::optimizer
