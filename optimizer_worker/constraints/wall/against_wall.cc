// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/wall/against_wall.h"

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "optimizer_worker/constraints/measure/walls.h"

namespace flair::optimizer {

template <typename T>
T AgainstWall::operator()(const Frames<T, 1>& frames) const {
  return LeastOf<T>(walls, frames,
                    [this](const Wall& wall, const auto& f) { return SideOnWall(footprint, f[0], side, wall); });
}

ConstraintFacts AgainstWallFacts() {
  return {
      .name = "against_wall",
      .aliases = {"ind_next_to_wall", "io_next_to_wall"},
      .family = "wall",
      .summary = "The given side of `object` (its back by default) lies flush on a wall.",
      .doc =
          "cost = min over walls of gap^2 + (1 - cos angle) + overhang^2 [m2]: signed gap of the side's middle to the "
          "wall, angle between the side and the wall, overhang beyond the wall's ends. The released function "
          "multiplies the distances to two walls instead.",
      .parameters = {ObjectParameter("object", "What stands at the wall."),
                     SideParameter("side", "Its side that touches the wall.", Side::kBack),
                     OptionalWall("wall", "The wall; any wall when left out.")},
      .sentences = {{"The bed's headboard is against a wall.", "object=bed"},
                    {"The wardrobe stands with its back against the north wall.", "object=wardrobe wall=north"},
                    {"The desk's left side touches a wall.", "object=desk side=left"}},
      .layouts = {Satisfied("4x3 room; desk 1.2x0.6 at 2,0.3,0", "object=desk"),
                  Satisfied("4x3 room; desk 1.2x0.6 at 3.7,1,90", "object=desk wall=east"),
                  Violated("4x3 room; desk 1.2x0.6 at 2,0.9,20", "object=desk"),
                  Violated("4x3 room; desk 1.2x0.6 at 2,0.3,0", "object=desk wall=east"),
                  Violated("4x3 room; desk 1.2x0.6 at 2,0.3,0", "object=desk side=left")},
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        const int object = a.Object("object");
        return MakeCost(AgainstWall{FootprintOf(context, object), a.OneSide("side"),
                                    WallsToUse(context.scene.room, a.MaybeWall("wall"))},
                        {object});
      }};
}

}  // namespace flair::optimizer
