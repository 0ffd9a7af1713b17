// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/pair/under_center.h"

#include "optimizer_worker/autodiff/smooth.h"
#include "optimizer_worker/constraints/facts.h"

namespace flair::optimizer {

template <typename T>
T UnderCenter::operator()(const Frames<T, 2>& frames) const {
  return SquaredNorm(frames[0].center - frames[1].center) + Square(Cross(frames[0].front, frames[1].front));
}

ConstraintFacts UnderCenterFacts() {
  return {
      .name = "under_center",
      .aliases = {"io_under_central"},
      .family = "pair",
      .summary = "`object` lies centred under `target`, its sides parallel to the target's.",
      .doc = "cost = squared distance of the centres + sin^2 of the difference of headings [m2].",
      .parameters = {ObjectParameter("object", "What lies below."), ObjectParameter("target", "What stands above.")},
      .sentences = {{"The rug is centred under the dining table, parallel to it.", "object=rug target=table"}},
      .layouts = {Satisfied("5x4 room; rug 3x2 at 2,2,180 rug; table 1.6x0.9 at 2,2,0", "object=rug target=table"),
                  Violated("5x4 room; rug 3x2 at 2,2.3,10 rug; table 1.6x0.9 at 2,2,0", "object=rug target=table")},
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        return MakeCost(UnderCenter{}, {a.Object("object"), a.Object("target")});
      }};
}

}  // namespace flair::optimizer
