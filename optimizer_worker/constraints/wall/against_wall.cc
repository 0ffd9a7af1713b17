// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps one side of an object (its back by default) on a wall.
//   cost = min over walls of  gap^2 + (1 - cos a) + overhang^2                                    [m2]
//   gap       signed distance of the side's middle to the wall's line, so that beyond the wall is an error too
//   a         angle between the side's outward normal and the direction into the wall
//   overhang  how far the side sticks out beyond the wall's ends (matters at inner corners)
// Zero exactly when the whole side lies on the wall. Smooth but where the nearest wall changes.
// The released ind_next_to_wall multiplies the distances to two walls, so that the same gap costs more in a larger
// room; SEMANTICS.md section 3 names this form as correct.
#include <vector>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "optimizer_worker/constraints/measure/walls.h"
#include "room/geometry/footprint.h"
#include "room/scene/room.h"

namespace flair::optimizer {

namespace {

struct AgainstWall {
  static constexpr int kObjects = 1;
  static constexpr bool kSeesZero = true;
  Footprint footprint;
  Side side;
  // The walls to choose from.
  std::vector<Wall> walls;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const {
    return LeastOf<T>(walls, frames,
                      [this](const Wall& wall, const auto& f) { return SideOnWall(footprint, f[0], side, wall); });
  }
};

std::optional<Shortfall> AgainstWallShortfall(const PlacedCall& call) {
  const int object = call.object();
  const Side side = call.arguments().OneSide("side");
  const Wall& wall =
      call.BestWall([&](const Wall& w) { return SideOnWall(call.FootprintOf(object), call.FrameOf(object), side, w); });
  return Worst(OffWall(call, object, side, wall));
}

}  // namespace

ConstraintFacts AgainstWallFacts() {
  return {
      .name = "against_wall",
      .aliases = {"ind_next_to_wall", "io_next_to_wall"},
      .family = "wall",
      .summary = "The given side of `object` (its back by default) lies flush on a wall.",
      .phrase = "has its {side} flush on {wall|a wall}",
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
      .shortfall = AgainstWallShortfall,
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        const int object = a.Object("object");
        return MakeCost(AgainstWall{FootprintOf(context, object), a.OneSide("side"),
                                    WallsToUse(context.scene.room, a.MaybeWall("wall"))},
                        {object});
      }};
}

}  // namespace flair::optimizer
