// SPDX-License-Identifier: GPL-3.0-or-later
// Puts an object's back on a wall, in the middle of it.
//   cost = min over walls of  (cost of against_wall) + (offset - L / 2)^2                                    [m2]
//   offset  place of the back's middle along the wall of length L
// Zero exactly when the back lies on the wall, centred.
#include <vector>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "optimizer_worker/constraints/measure/walls.h"
#include "room/geometry/footprint.h"
#include "room/scene/room.h"

namespace flair::optimizer {

namespace {

struct CenteredOnWall {
  static constexpr int kObjects = 1;
  static constexpr bool kSeesZero = true;
  Footprint footprint;
  std::vector<Wall> walls;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const {
    return LeastOf<T>(walls, frames, [this](const Wall& wall, const auto& f) {
      return SideOnWall(footprint, f[0], Side::kBack, wall) + Square(wall.Offset(f[0].center) - wall.length_m / 2);
    });
  }
};

std::optional<Shortfall> CenteredOnWallShortfall(const PlacedCall& call) {
  const int object = call.object();
  const Frame<double> frame = call.FrameOf(object);
  const auto aside = [&](const Wall& w) { return w.Offset(frame.center) - w.length_m / 2; };
  const Wall& wall = call.BestWall(
      [&](const Wall& w) { return SideOnWall(call.FootprintOf(object), frame, Side::kBack, w) + aside(w) * aside(w); });
  std::vector<Shortfall> misses = OffWall(call, object, Side::kBack, wall);
  misses.push_back(OffBy(call.Name(object), "the middle of " + WallName(wall), aside(wall)));
  return Worst(misses);
}

}  // namespace

ConstraintFacts CenteredOnWallFacts() {
  return {.name = "centered_on_wall",
          .family = "wall",
          .summary = "`object` stands with its back on a wall, in the middle of that wall.",
          .phrase = "stands in the middle of {wall|a wall}, its back on it",
          .doc = "cost = min over walls of the cost of against_wall + squared distance from the wall's middle [m2].",
          .parameters = {ObjectParameter("object", "What is centred."),
                         OptionalWall("wall", "The wall; any when left out.")},
          .sentences = {{"The bed is centred on the north wall.", "object=bed wall=north"},
                        {"The headboard is in the middle of a wall.", "object=bed"}},
          .layouts = {Satisfied("4x3 room; bed 1.6x2 at 2,1,0", "object=bed wall=south"),
                      Violated("4x3 room; bed 1.6x2 at 2.4,1,5", "object=bed")},
          .shortfall = CenteredOnWallShortfall,
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            const int object = a.Object("object");
            return MakeCost(
                CenteredOnWall{FootprintOf(context, object), WallsToUse(context.scene.room, a.MaybeWall("wall"))},
                {object});
          }};
}

}  // namespace flair::optimizer
