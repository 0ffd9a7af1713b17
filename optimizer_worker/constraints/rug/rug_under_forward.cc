// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/rug/rug_under_forward.h"

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/measure/walls.h"

namespace flair::optimizer {

template <typename T>
T RugUnderForward::operator()(const Frames<T, 2>& frames) const {
  const Vec2<T>& along = rug.width_m >= rug.depth_m ? frames[0].right : frames[0].front;
  return SquaredNorm(frames[0].center - MiddleOf(object, frames[1], Side::kFront)) +
         Square(Cross(along, frames[1].right));
}

ConstraintFacts RugUnderForwardFacts() {
  return {.name = "rug_under_forward",
          .aliases = {"rug_under_central_forward"},
          .family = "rug",
          .summary = "`rug` lies under the front of `object`, centred on its front edge, the longer side along it.",
          .doc =
              "cost = squared distance of the rug's centre to the middle of the front + sin^2 of the angle between the "
              "rug's "
              "longer side and the object's back [m2].",
          .parameters = {ObjectParameter("rug", "The rug."), ObjectParameter("object", "What stands half on it.")},
          .sentences = {{"A rug lies at the foot of the bed.", "rug=rug object=bed"},
                        {"A rug extends from under the sofa.", "rug=rug object=sofa"}},
          .layouts = {Satisfied("5x4 room; rug 2x1.4 at 2,2,0 rug; bed 1.6x2 at 2,1,0", "rug=rug object=bed"),
                      Satisfied("5x4 room; rug 1.4x2 at 2,2,270 rug; bed 1.6x2 at 2,1,0", "rug=rug object=bed"),
                      Violated("5x4 room; rug 2x1.4 at 2,1.5,10 rug; bed 1.6x2 at 2,1,0", "rug=rug object=bed")},
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            const int rug = a.Object("rug");
            const int object = a.Object("object");
            return MakeCost(RugUnderForward{FootprintOf(context, rug), FootprintOf(context, object)}, {rug, object});
          }};
}

}  // namespace flair::optimizer
