// SPDX-License-Identifier: GPL-3.0-or-later
// Lays a rug half under an object and half before it.
//   cost = |c_rug - m|^2 + (1 - cos^2 a)                                                                       [m2]
//   m  middle of the object's front;  a  angle between the rug's longer side and the object's back edge
// Zero exactly when the rug is centred on the front edge, its longer side along it; a half turn is the same. The
// released rug_under_central_forward compares directed edges by arccos without clipping (SEMANTICS.md section 6).
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/walls.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

namespace {

struct RugUnderForward {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;
  Footprint rug;
  Footprint object;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const {
    const Vec2<T>& along = rug.width_m >= rug.depth_m ? frames[0].right : frames[0].front;
    return SquaredNorm(frames[0].center - MiddleOf(object, frames[1], Side::kFront)) +
           Square(Cross(along, frames[1].right));
  }
};

std::optional<Shortfall> RugUnderForwardShortfall(const PlacedCall& call) {
  const int rug = call.arguments().Object("rug"), object = call.object();
  const Vec2<double> front = MiddleOf(call.FootprintOf(object), call.FrameOf(object), Side::kFront);
  if (const std::optional<Shortfall> off = Worst(
          {OffBy(call.Name(rug), SideOf(call.Name(object), Side::kFront), Norm(call.FrameOf(rug).center - front))})) {
    return off;
  }
  return Worst({OffBy(call.Name(rug), "lying along " + call.Name(object), call.CostRoot())});
}

}  // namespace

ConstraintFacts RugUnderForwardFacts() {
  return {.name = "rug_under_forward",
          .aliases = {"rug_under_central_forward"},
          .family = "rug",
          .summary = "`rug` lies under the front of `object`, centred on its front edge, the longer side along it.",
          .phrase = "lies half under {object}, before its front",
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
          .shortfall = RugUnderForwardShortfall,
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            const int rug = a.Object("rug");
            const int object = a.Object("object");
            return MakeCost(RugUnderForward{FootprintOf(context, rug), FootprintOf(context, object)}, {rug, object});
          }};
}

}  // namespace flair::optimizer
