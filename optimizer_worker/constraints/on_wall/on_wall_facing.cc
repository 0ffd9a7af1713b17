// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/on_wall/on_wall_facing.h"

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/measure/choose.h"

namespace flair::optimizer {

template <typename T>
T OnWallFacing::operator()(const Frames<T, 2>& frames) const {
  const Vec2<T> p = frames[1].ToObject(frames[0].center);
  return LeastOf<T>(places, frames,
                    [this](const HangingWall& place, const auto& f) { return HangsOn(object, f[0], place); }) +
         SquaredOutside(p.x, -target.width_m / 4, target.width_m / 4) + SquaredHinge(-p.y) +
         (Dot(frames[0].front, frames[1].front) + 1.0);
}

ConstraintFacts OnWallFacingFacts() {
  return {
      .name = "on_wall_facing",
      .family = "on_wall",
      .summary = "`object` hangs on the wall that `target` looks at, straight ahead of it and turned to it.",
      .doc =
          "cost = cost of hanging on the best wall + squared lateral offset beyond the target's middle half + squared "
          "distance behind it + (1 + cos of the difference of headings) [m2].",
      .parameters = {ObjectParameter("object", "What hangs."), ObjectParameter("target", "What looks at it.")},
      .sentences = {{"The television hangs on the wall opposite the sofa.", "object=tv target=sofa"}},
      .layouts = {Satisfied("5x4 room; tv 1.2x0.08 at 2.3,3.96,180 wall; sofa 2x1 at 2,0.5,0", "object=tv target=sofa"),
                  Violated("5x4 room; tv 1.2x0.08 at 3.3,3.96,180 wall; sofa 2x1 at 2,0.5,0", "object=tv target=sofa"),
                  Violated("5x4 room; tv 1.2x0.08 at 0.04,2,270 wall; sofa 2x1 at 2,0.5,0", "object=tv target=sofa")},
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
