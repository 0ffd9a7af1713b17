// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/wall/centered_on_wall.h"

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "optimizer_worker/constraints/measure/walls.h"

namespace flair::optimizer {

template <typename T>
T CenteredOnWall::operator()(const Frames<T, 1>& frames) const {
  return LeastOf<T>(walls, frames, [this](const Wall& wall, const auto& f) {
    return SideOnWall(footprint, f[0], Side::kBack, wall) + Square(wall.Offset(f[0].center) - wall.length_m / 2);
  });
}

ConstraintFacts CenteredOnWallFacts() {
  return {.name = "centered_on_wall",
          .family = "wall",
          .summary = "`object` stands with its back on a wall, in the middle of that wall.",
          .doc = "cost = min over walls of the cost of against_wall + squared distance from the wall's middle [m2].",
          .parameters = {ObjectParameter("object", "What is centred."),
                         OptionalWall("wall", "The wall; any when left out.")},
          .sentences = {{"The bed is centred on the north wall.", "object=bed wall=north"},
                        {"The headboard is in the middle of a wall.", "object=bed"}},
          .layouts = {Satisfied("4x3 room; bed 1.6x2 at 2,1,0", "object=bed wall=south"),
                      Violated("4x3 room; bed 1.6x2 at 2.4,1,5", "object=bed")},
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            const int object = a.Object("object");
            return MakeCost(
                CenteredOnWall{FootprintOf(context, object), WallsToUse(context.scene.room, a.MaybeWall("wall"))},
                {object});
          }};
}

}  // namespace flair::optimizer
