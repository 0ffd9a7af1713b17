// SPDX-License-Identifier: GPL-3.0-or-later
// Hangs a wall object near a floor object.
//   cost = min over walls of  (on_wall) + max(s - 0.5, 0)^2 + max(p - max(p_min, 0.5), 0)^2                      [m2]
//   on_wall  cost of hanging on that wall, off its openings (room/on_wall.h)
//   s        gap between the two along the wall;  p  distance of the target's nearest corner to that wall, p_min to any
//   wall
// Zero exactly when it hangs on the target's nearest wall (or one within half a metre of it), at most half a metre
// beside it. The released on_wall_near adds the squared distance of the centres and is never zero (SEMANTICS.md section
// 6).
#include <vector>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/beside.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "optimizer_worker/constraints/room/on_wall.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

namespace {

struct OnWallNear {
  static constexpr int kObjects = 2;
  static constexpr bool kSeesZero = true;
  Footprint object;
  Footprint target;
  std::vector<HangingWall> places;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const {
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
};

std::optional<Shortfall> OnWallNearShortfall(const PlacedCall& call) {
  const double reach = call.FootprintOf(call.object()).width_m / 2 + 0.5;
  return Worst(OffBeside(call, reach, 0.5, "beside"));
}

}  // namespace

ConstraintFacts OnWallNearFacts() {
  return {
      .name = "on_wall_near",
      .family = "on_wall",
      .summary = "`object` hangs on a wall close to `target`, at most half a metre beside it.",
      .phrase = "hangs close to {target}",
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
      .shortfall = OnWallNearShortfall,
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
