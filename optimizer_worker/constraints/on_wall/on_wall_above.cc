// SPDX-License-Identifier: GPL-3.0-or-later
// Hangs a wall object above a floor object.
//   cost = min over walls of  (on_wall) + max(|m_1 - m_2| - play, 0)^2 + max(p - max(p_min, 0.15), 0)^2            [m2]
//   on_wall   cost of hanging on that wall, off its openings (room/on_wall.h)
//   m_1, m_2  middles of the two along the wall;  p, p_min  as in on_wall_near.cc
//   play      0 for the only thing above the target, else what it can move above it: several share the place
// Zero exactly when it hangs on the wall that the target stands at, above its middle.
#include <vector>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/beside.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "optimizer_worker/constraints/room/on_wall.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

namespace {

struct OnWallAbove {
  static constexpr int kObjects = 2;
  static constexpr bool kSeesZero = true;
  Footprint object;
  Footprint target;
  std::vector<HangingWall> places;
  bool shares_place;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const {
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
};

std::optional<Shortfall> OnWallAboveShortfall(const PlacedCall& call) {
  return Worst(OffBeside(call, 0, 0.15, "the middle of"));
}

}  // namespace

ConstraintFacts OnWallAboveFacts() {
  return {
      .name = "on_wall_above",
      .aliases = {"on_wall_above_central"},
      .family = "on_wall",
      .summary = "`object` hangs on the wall that `target` stands at, above its middle.",
      .phrase = "hangs above {target}",
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
      .shortfall = OnWallAboveShortfall,
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
