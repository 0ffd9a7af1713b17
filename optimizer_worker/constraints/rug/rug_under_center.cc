// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/rug/rug_under_center.h"

#include "optimizer_worker/constraints/facts.h"

namespace flair::optimizer {

template <typename T>
T RugUnderCenter::operator()(const Frames<T, 2>& frames) const {
  return SquaredNorm(frames[0].center - frames[1].center);
}

ConstraintFacts RugUnderCenterFacts() {
  return {.name = "rug_under_center",
          .aliases = {"rug_under_central"},
          .family = "rug",
          .summary = "`rug` lies centred under `object`.",
          .doc = "cost = squared distance of the centres [m2], as released.",
          .parameters = {ObjectParameter("rug", "The rug."), ObjectParameter("object", "What stands on it.")},
          .sentences = {{"A rug lies under the coffee table.", "rug=rug object=table"}},
          .layouts = {Satisfied("5x4 room; rug 3x2 at 2,2,0 rug; table 1x1 at 2,2,0", "rug=rug object=table"),
                      Violated("5x4 room; rug 3x2 at 2.4,2.1,0 rug; table 1x1 at 2,2,0", "rug=rug object=table")},
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            return MakeCost(RugUnderCenter{}, {a.Object("rug"), a.Object("object")});
          }};
}

}  // namespace flair::optimizer
