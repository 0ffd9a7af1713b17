// SPDX-License-Identifier: GPL-3.0-or-later
// Gives two objects the same heading: cost = 1 - cos(theta_1 - theta_2). Zero exactly when both face the same way. The
// released io_parallel squares the difference of headings reduced to [0, 2 pi), which jumps by 39 at the wrap
// (SEMANTICS.md section 4).
#include "optimizer_worker/autodiff/smooth.h"
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"

namespace flair::optimizer {

namespace {

struct Parallel {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const {
    return Turn(frames[0].front, frames[1].front);
  }
};

std::optional<Shortfall> ParallelShortfall(const PlacedCall& call) {
  return Worst({Turned(call.NameOf("object"), "the direction of " + call.NameOf("target"),
                       AngleOf(call.FrameOf(call.object()).front, call.FrameOf(call.target()).front))});
}

}  // namespace

ConstraintFacts ParallelFacts() {
  return {.name = "parallel",
          .aliases = {"io_parallel", "p_parallel"},
          .family = "pair",
          .summary = "`object` and `target` face the same way.",
          .phrase = "faces the same way as {target}",
          .doc = "cost = 1 - cos(difference of headings). The released function jumps where headings wrap.",
          .parameters = {ObjectParameter("object", "The one."), ObjectParameter("target", "The other.")},
          .sentences = {{"The two beds are parallel.", "object=bed_1 target=bed_2"}},
          .layouts = {Satisfied("5x4 room; a 1x2 at 1,1,10; b 1x2 at 3,1,370", "object=a target=b"),
                      Violated("5x4 room; a 1x2 at 1,1,10; b 1x2 at 3,1,40", "object=a target=b"),
                      Violated("5x4 room; a 1x2 at 1,1,1; b 1x2 at 3,1,180", "object=a target=b")},
          .shortfall = ParallelShortfall,
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            return MakeCost(Parallel{}, {a.Object("object"), a.Object("target")});
          }};
}

}  // namespace flair::optimizer
