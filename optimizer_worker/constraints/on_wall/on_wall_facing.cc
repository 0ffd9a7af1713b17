// SPDX-License-Identifier: GPL-3.0-or-later
// Hangs a wall object where a floor object looks: a television before the sofa, a mirror before the chair.
//   cost = (on_wall) + max(|u| - w / 4, 0)^2 + max(-v, 0)^2 + (1 + f1 . f2)                                       [m2]
//   on_wall  cost of hanging on the best wall (room/on_wall.h)
//   u, v     how far right and ahead of the target the object's centre is;  w  the target's width;  f1, f2  front
//   directions
// Zero exactly when it hangs on a wall straight ahead of the target's middle half, looking back at it.
#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "optimizer_worker/constraints/room/on_wall.h"
#include "room/geometry/footprint.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {

namespace {

struct OnWallFacing {
  static constexpr int kObjects = 2;
  Footprint object;
  Footprint target;
  std::vector<HangingWall> places;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const {
    const Vec2<T> p = frames[1].ToObject(frames[0].center);
    return LeastOf<T>(places, frames,
                      [this](const HangingWall& place, const auto& f) { return HangsOn(object, f[0], place); }) +
           SquaredOutside(p.x, -target.width_m / 4, target.width_m / 4) + SquaredHinge(-p.y) +
           (Dot(frames[0].front, frames[1].front) + 1.0);
  }
};

std::optional<Shortfall> OnWallFacingShortfall(const PlacedCall& call) {
  const int object = call.object(), target = call.target();
  const Frame<double> frame = call.FrameOf(target);
  const Vec2<double> p = frame.ToObject(call.FrameOf(object).center);
  const double aside = std::abs(p.x) - call.FootprintOf(target).width_m / 4;
  return Worst({{fmt::format("{} hangs {:.2f} m to the side of where {} looks", call.Name(object), std::max(0.0, aside),
                             call.Name(target)),
                 aside, "m"},
                {fmt::format("{} hangs {:.2f} m behind {}", call.Name(object), -p.y, call.Name(target)), -p.y, "m"},
                Turned(SideOf(call.Name(target), Side::kFront), call.Name(object),
                       kPi - AngleOf(frame.front, call.FrameOf(object).front)),
                NotHanging(call, object)});
}

}  // namespace

ConstraintFacts OnWallFacingFacts() {
  return {
      .name = "on_wall_facing",
      .family = "on_wall",
      .summary = "`object` hangs on the wall that `target` looks at, straight ahead of it and turned to it.",
      .phrase = "hangs where {target} looks",
      .doc =
          "cost = cost of hanging on the best wall + squared lateral offset beyond the target's middle half + squared "
          "distance behind it + (1 + cos of the difference of headings) [m2].",
      .parameters = {ObjectParameter("object", "What hangs."), ObjectParameter("target", "What looks at it.")},
      .sentences = {{"The television hangs on the wall opposite the sofa.", "object=tv target=sofa"}},
      .layouts = {Satisfied("5x4 room; tv 1.2x0.08 at 2.3,3.96,180 wall; sofa 2x1 at 2,0.5,0", "object=tv target=sofa"),
                  Violated("5x4 room; tv 1.2x0.08 at 3.3,3.96,180 wall; sofa 2x1 at 2,0.5,0", "object=tv target=sofa"),
                  Violated("5x4 room; tv 1.2x0.08 at 0.04,2,270 wall; sofa 2x1 at 2,0.5,0", "object=tv target=sofa")},
      .shortfall = OnWallFacingShortfall,
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        const int object = a.Object("object");
        const int target = a.Object("target");
        return MakeCost(
            OnWallFacing{FootprintOf(context, object), FootprintOf(context, target),
                         HangingWalls(context.scene.room, context.scene.BottomOf(object), context.scene.TopOf(object))},
            {object, target});
      }};
}

}  // namespace flair::optimizer
