// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/on_wall/on_wall_above.h"

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/measure/beside.h"
#include "optimizer_worker/constraints/measure/choose.h"

namespace flair::optimizer {

template <typename T>
T OnWallAbove::operator()(const Frames<T, 2>& frames) const {
  const NearestWall nearest = NearestWallTo(target, ValueOf(frames[1]), places);
  return LeastOf<T>(places, frames, [this, &nearest](const HangingWall& place, const auto& f) {
    using S = std::decay_t<decltype(f[0].center.x)>;
    constexpr double kAtWall_m = 0.15;
    const WallView<S> view(target, f[1], place.wall);
    const S beside = Magnitude(place.wall.Offset(f[0].center) - view.Middle());
    const S play = shares_place ? Positive(0.5 * (view.Length() - object.width_m)) : S(0.0);
    return HangsOn(object, f[0], place) + SquaredHinge(beside - play) +
           SquaredNotItsWall(target, f[1], view.distance, nearest, kAtWall_m);
  });
}

ConstraintFacts OnWallAboveFacts() {
  return {
      .name = "on_wall_above",
      .aliases = {"on_wall_above_central"},
      .family = "on_wall",
      .summary = "`object` hangs on the wall that `target` stands at, above its middle.",
      .doc =
          "cost = min over walls of the cost of hanging there + squared distance of the middles along the wall (beyond "
          "the "
          "play when several hang there) + squared excess of the target's distance to that wall over its distance to "
          "the "
          "nearest [m2].",
      .parameters = {ObjectParameter("object", "What hangs."), ObjectParameter("target", "What it hangs above.")},
      .sentences = {{"A painting hangs above the bed.", "object=painting target=bed"},
                    {"A shelf is mounted on the wall over the desk.", "object=shelf target=desk"}},
      .layouts = {Satisfied("5x4 room; art 0.6x0.04 at 2,0.02,0 wall; bed 1.6x2 at 2,1,0", "object=art target=bed"),
                  Violated("5x4 room; art 0.6x0.04 at 2.6,0.02,5 wall; bed 1.6x2 at 2,1,0", "object=art target=bed"),
                  Violated("5x4 room; art 0.6x0.04 at 2,3.98,180 wall; bed 1.6x2 at 2,1,0", "object=art target=bed")},
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        const int object = a.Object("object");
        const int target = a.Object("target");
        const bool shares = context.linked != nullptr && context.linked->CountAbove(target) > 1;
        return MakeCost(
            OnWallAbove{FootprintOf(context, object), FootprintOf(context, target),
                        HangingWalls(context.scene.room, context.scene.BottomOf(object), context.scene.TopOf(object)),
                        shares},
            {object, target});
      }};
}

}  // namespace flair::optimizer
