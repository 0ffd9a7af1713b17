// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/wall/near_wall.h"

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "optimizer_worker/constraints/measure/walls.h"

namespace flair::optimizer {

template <typename T>
T NearWall::operator()(const Frames<T, 1>& frames) const {
  return LeastOf<T>(walls, frames, [this](const Wall& wall, const auto& f) {
    constexpr double kCos45 = 0.70710678118654757;
    const auto middle = MiddleOf(footprint, f[0], side);
    return SquaredOutside(wall.Height(middle), 0, max_distance_m) +
           SquaredHinge(TurnToWall(f[0], side, wall) - (1 - kCos45)) +
           SquaredOutside(wall.Offset(middle), 0, wall.length_m);
  });
}

ConstraintFacts NearWallFacts() {
  return {.name = "near_wall",
          .aliases = {"ind_near_wall", "io_near_wall"},
          .family = "wall",
          .summary = "The given side of `object` (its back by default) is within `max_distance_m` of a wall.",
          .doc =
              "cost = min over walls of squared excess of the side's mean distance over max_distance_m, of its angle "
              "over 45 "
              "degrees and of its place beyond the wall's ends [m2]. The released function ignores the side.",
          .parameters = {ObjectParameter("object", "What is near a wall."),
                         SideParameter("side", "Its side that looks at the wall.", Side::kBack),
                         OptionalWall("wall", "The wall; any wall when left out."),
                         LengthParameter("max_distance_m", "Largest mean distance of the side.", 0, 20, 0.5)},
          .sentences = {{"The sofa is near a wall.", "object=sofa"},
                        {"The bookshelf is within 20 cm of the wall.", "object=bookshelf max_distance_m=0.2"}},
          .layouts = {Satisfied("4x3 room; sofa 2x0.9 at 2,0.9,10", "object=sofa"),
                      Violated("4x3 room; sofa 2x0.9 at 2,1.4,10", "object=sofa"),
                      Violated("4x3 room; sofa 2x0.9 at 2,0.45,0", "object=sofa side=front")},
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            const int object = a.Object("object");
            return MakeCost(NearWall{FootprintOf(context, object), a.OneSide("side"), a.Number("max_distance_m"),
                                     WallsToUse(context.scene.room, a.MaybeWall("wall"))},
                            {object});
          }};
}

}  // namespace flair::optimizer
