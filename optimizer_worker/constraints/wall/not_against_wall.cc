// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/wall/not_against_wall.h"

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/measure/gap.h"

namespace flair::optimizer {

template <typename T>
T NotAgainstWall::operator()(const Frames<T, 1>& frames) const {
  T sum(0.0);
  if (!convex && !side.has_value()) {
    const Box<T> box(footprint, frames[0]);
    for (const ConvexPiece& piece : pieces) sum += SquaredNearness<T>(box, piece, min_distance_m);
    return sum;
  }
  const auto corner_cost = [this, &sum](const Vec2<T>& corner) {
    for (const Wall& wall : walls) {
      const bool beside = ValueOf(wall.Offset(corner)) < 0 || ValueOf(wall.Offset(corner)) > wall.length_m;
      if (convex || !beside) sum += SquaredHinge(min_distance_m - wall.Height(corner));
    }
  };
  if (side.has_value()) {
    const SideEdge<T> edge = EdgeOf(footprint, frames[0], *side);
    corner_cost(edge.first);
    corner_cost(edge.second);
  } else {
    for (const Vec2<T>& corner : Corners(footprint, frames[0])) corner_cost(corner);
  }
  return sum;
}

ConstraintFacts NotAgainstWallFacts() {
  return {
      .name = "not_against_wall",
      .aliases = {"ind_not_against_wall", "io_not_against_wall", "ind_not_next_to_wall"},
      .family = "wall",
      .summary = "`object` (or its given side) is at least `min_distance_m` from every wall.",
      .doc =
          "cost = sum over corners and walls of max(min_distance_m - distance, 0)^2 [m2]. The released function is 10 "
          "times this and calls places beyond the wall fine.",
      .parameters = {ObjectParameter("object", "What stands free."),
                     OptionalSide("side", "Only this side keeps away; the whole object when left out."),
                     LengthParameter("min_distance_m", "Smallest distance.", 0, 20, 0.2)},
      .sentences = {{"The dining table is not against a wall.", "object=table"},
                    {"The sofa floats in the room, at least half a metre off the walls.",
                     "object=sofa min_distance_m=0.5"}},
      .layouts = {Satisfied("4x3 room; table 1x1 at 2,1.5,45", "object=table"),
                  Violated("4x3 room; table 1x1 at 0.6,1.5,10", "object=table"),
                  Satisfied("4x3 room; table 1x1 at 2,0.6,0", "object=table side=front"),
                  Violated("4x3 room; table 1x1 at 2,0.6,0", "object=table side=back"),
                  Violated("room 0,0 4,0 4,2 2,2 2,4 0,4; table 1x1 at 1.4,2.6,0", "object=table")},
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        const int object = a.Object("object");
        const Room& room = context.scene.room;
        NotAgainstWall formula{FootprintOf(context, object), a.MaybeSide("side"),
                               a.Number("min_distance_m"),   room.walls,
                               IsConvex(room.floor),         {}};
        for (const Wall& wall : room.walls) formula.pieces.emplace_back(Segment{wall.start, wall.end});
        return MakeCost(std::move(formula), {object});
      }};
}

}  // namespace flair::optimizer
