// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/pair/parallel.h"

#include "optimizer_worker/autodiff/smooth.h"
#include "optimizer_worker/constraints/facts.h"

namespace flair::optimizer {

template <typename T>
T Parallel::operator()(const Frames<T, 2>& frames) const {
  return Turn(frames[0].front, frames[1].front);
}

ConstraintFacts ParallelFacts() {
  return {.name = "parallel",
          .aliases = {"io_parallel", "p_parallel"},
          .family = "pair",
          .summary = "`object` and `target` face the same way.",
          .doc = "cost = 1 - cos(difference of headings). The released function jumps where headings wrap.",
          .parameters = {ObjectParameter("object", "The one."), ObjectParameter("target", "The other.")},
          .sentences = {{"The two beds are parallel.", "object=bed_1 target=bed_2"}},
          .layouts = {Satisfied("5x4 room; a 1x2 at 1,1,10; b 1x2 at 3,1,370", "object=a target=b"),
                      Violated("5x4 room; a 1x2 at 1,1,10; b 1x2 at 3,1,40", "object=a target=b"),
                      Violated("5x4 room; a 1x2 at 1,1,1; b 1x2 at 3,1,180", "object=a target=b")},
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            return MakeCost(Parallel{}, {a.Object("object"), a.Object("target")});
          }};
}

}  // namespace flair::optimizer
