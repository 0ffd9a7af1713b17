// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/on_wall/on_wall_near.h"

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/measure/beside.h"
#include "optimizer_worker/constraints/measure/choose.h"

namespace flair::optimizer {

template <typename T>
T OnWallNear::operator()(const Frames<T, 2>& frames) const {
  const NearestWall nearest = NearestWallTo(target, ValueOf(frames[1]), places);
  return LeastOf<T>(places, frames, [this, &nearest](const HangingWall& place, const auto& f) {
    using S = std::decay_t<decltype(f[0].center.x)>;
    constexpr double kBeside_m = 0.5;
    const WallView<S> view(target, f[1], place.wall);
    const S offset = place.wall.Offset(f[0].center);
    const double reach = object.width_m / 2 + kBeside_m;
    return HangsOn(object, f[0], place) + SquaredHinge(view.low - offset - reach) +
           SquaredHinge(offset - view.high - reach) +
           SquaredNotItsWall(target, f[1], view.distance, nearest, kBeside_m);
  });
}

ConstraintFacts OnWallNearFacts() {
  return {
      .name = "on_wall_near",
      .family = "on_wall",
      .summary = "`object` hangs on a wall close to `target`, at most half a metre beside it.",
      .doc =
          "cost = min over walls of the cost of hanging there + squared gap along the wall beyond 0.5 m + squared "
          "excess "
          "of the target's distance to that wall over its distance to the nearest [m2]. The released function is never "
          "zero.",
      .parameters = {ObjectParameter("object", "What hangs."), ObjectParameter("target", "What it hangs near.")},
      .sentences = {{"A mirror hangs on the wall near the dressing table.", "object=mirror target=table"}},
      .layouts = {Satisfied("5x4 room; art 0.6x0.04 at 3.2,0.02,0 wall; bed 1.6x2 at 2,1,0", "object=art target=bed"),
                  Violated("5x4 room; art 0.6x0.04 at 4.2,0.02,0 wall; bed 1.6x2 at 1.5,1,0", "object=art target=bed"),
                  Violated("5x4 room; art 0.6x0.04 at 2,3.98,180 wall; bed 1.6x2 at 2,1,0", "object=art target=bed")},
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        const int object = a.Object("object");
        const int target = a.Object("target");
        return MakeCost(
            OnWallNear{FootprintOf(context, object), FootprintOf(context, target),
                       HangingWalls(context.scene.room, context.scene.BottomOf(object), context.scene.TopOf(object))},
            {object, target});
      }};
}

}  // namespace flair::optimizer
