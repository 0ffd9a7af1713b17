// SPDX-License-Identifier: GPL-3.0-or-later
// Lays an object under the middle of another: cost = |c1 - c2|^2 + sin^2(theta_1 - theta_2) [m2]. Zero exactly when the
// centres meet and the sides are parallel; a half turn is the same. The released io_under_central compares headings
// that wrap.
#include "optimizer_worker/autodiff/smooth.h"
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {

namespace {

struct UnderCenter {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const {
    return SquaredNorm(frames[0].center - frames[1].center) + Square(Cross(frames[0].front, frames[1].front));
  }
};

std::optional<Shortfall> UnderCenterShortfall(const PlacedCall& call) {
  const Frame<double> object = call.FrameOf(call.object()), target = call.FrameOf(call.target());
  const double angle = AngleOf(object.front, target.front);
  return Worst(
      {OffBy(call.NameOf("object"), "the middle of " + call.NameOf("target"), Norm(object.center - target.center)),
       Turned(call.NameOf("object"), "the sides of " + call.NameOf("target"), std::min(angle, kPi - angle))});
}

}  // namespace

ConstraintFacts UnderCenterFacts() {
  return {
      .name = "under_center",
      .aliases = {"io_under_central"},
      .family = "pair",
      .summary = "`object` lies centred under `target`, its sides parallel to the target's.",
      .phrase = "lies centred under {target}",
      .doc = "cost = squared distance of the centres + sin^2 of the difference of headings [m2].",
      .parameters = {ObjectParameter("object", "What lies below."), ObjectParameter("target", "What stands above.")},
      .sentences = {{"The rug is centred under the dining table, parallel to it.", "object=rug target=table"}},
      .layouts = {Satisfied("5x4 room; rug 3x2 at 2,2,180 rug; table 1.6x0.9 at 2,2,0", "object=rug target=table"),
                  Violated("5x4 room; rug 3x2 at 2,2.3,10 rug; table 1.6x0.9 at 2,2,0", "object=rug target=table")},
      .shortfall = UnderCenterShortfall,
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        return MakeCost(UnderCenter{}, {a.Object("object"), a.Object("target")});
      }};
}

}  // namespace flair::optimizer
