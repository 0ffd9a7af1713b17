// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps an object, or one of its sides, away from all walls.
//   cost = sum over corners C and walls of max(min - d(C, wall), 0)^2                                       [m2]
//   C  the object's corners, or the two ends of the given side;  d  signed distance to the wall's line in a convex room
// In other rooms d is the gap between the whole object and each wall, once per wall. Zero exactly when everything is at
// least min_distance_m from every wall. The released ind_not_against_wall is 10 times this, lets corners pass through
// walls and refuses the side that its own documentation names (SEMANTICS.md section 3).
#include <optional>
#include <vector>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/convex_piece.h"
#include "optimizer_worker/constraints/measure/gap.h"
#include "room/geometry/footprint.h"
#include "room/scene/room.h"

namespace flair::optimizer {

namespace {

struct NotAgainstWall {
  static constexpr int kObjects = 1;
  Footprint footprint;
  std::optional<Side> side;
  double min_distance_m;
  std::vector<Wall> walls;
  // The walls' lines bound the room.
  bool convex;
  // The same walls as pieces, for rooms that are not convex.
  std::vector<ConvexPiece> pieces;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const {
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
};

std::optional<Shortfall> NotAgainstWallShortfall(const PlacedCall& call) {
  const int object = call.object();
  const std::optional<Side> side = call.arguments().MaybeSide("side");
  const Box<double> box =
      side ? Box<double>::Before(call.FootprintOf(object), call.FrameOf(object), *side, 0) : call.BoxOf(object);
  const std::string what = side ? SideOf(call.Name(object), *side) : call.Name(object);
  std::vector<Shortfall> misses;
  for (const Wall& wall : call.scene().room.walls) {
    const ConvexPiece piece(Segment{wall.start, wall.end});
    misses.push_back(TooNear(what, WallName(wall), Gap<double>(box, piece), call.arguments().Number("min_distance_m")));
  }
  return Worst(misses);
}

}  // namespace

ConstraintFacts NotAgainstWallFacts() {
  return {
      .name = "not_against_wall",
      .aliases = {"ind_not_against_wall", "io_not_against_wall", "ind_not_next_to_wall"},
      .family = "wall",
      .summary = "`object` (or its given side) is at least `min_distance_m` from every wall.",
      .phrase = "keeps {min_distance_m} away from the walls",
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
      .shortfall = NotAgainstWallShortfall,
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
