// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/pair/not_facing.h"

#include "optimizer_worker/autodiff/smooth.h"
#include "optimizer_worker/constraints/facts.h"

namespace flair::optimizer {

template <typename T>
T NotFacing::operator()(const Frames<T, 2>& frames) const {
  constexpr double kCos45 = 0.70710678118654757;
  const Vec2<T> to_target = frames[1].center - frames[0].center;
  constexpr double kNoDirection_m2 = 1e-8;
  if (ValueOf(SquaredNorm(to_target)) < kNoDirection_m2) return T(0.0);
  return SquaredHinge(Dot(frames[0].front, to_target) / Length(to_target) - kCos45);
}

ConstraintFacts NotFacingFacts() {
  return {.name = "not_facing",
          .aliases = {"io_not_facing", "p_not_facing", "ind_not_facing"},
          .family = "pair",
          .summary = "`object` does not look at `target`, which is at least 45 degrees off its front.",
          .doc =
              "cost = max(cos(angle between front and direction to the target) - cos 45, 0)^2. The released function "
              "is always "
              "zero.",
          .parameters = {ObjectParameter("object", "What looks elsewhere."),
                         ObjectParameter("target", "What is not looked at.")},
          .sentences = {{"The bed does not face the mirror.", "object=bed target=mirror"},
                        {"The desk is turned away from the bed.", "object=desk target=bed"}},
          .layouts = {Satisfied("5x4 room; a 1x1 at 1,1,0; b 1x1 at 3,1,0", "object=a target=b"),
                      Violated("5x4 room; a 1x1 at 1,1,0; b 1x1 at 1.5,3,0", "object=a target=b")},
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            return MakeCost(NotFacing{}, {a.Object("object"), a.Object("target")});
          }};
}

}  // namespace flair::optimizer
