// SPDX-License-Identifier: GPL-3.0-or-later
// Puts an object into a corner of the room.
//   cost = min over corners K and the two ways round of  |C - K|^2 + (1 - cos a)                           [m2]
//   C  the object's corner between the given side and its neighbour;  a  angle between the side and its wall
// Zero exactly when the given side lies on one wall of the corner and the neighbouring side on the other. Only corners
// that open inwards count. The released ind_in_corner wants the object across the corner at 45 degrees and punishes the
// flush one (SEMANTICS.md section 3).
#include <vector>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "optimizer_worker/constraints/measure/walls.h"
#include "room/geometry/footprint.h"
#include "room/scene/room.h"

namespace flair::optimizer {

namespace {

// A corner of the room where the side can lie on the wall before or after it.
struct RoomCorner {
  Vec2<double> point;
  // The wall that the side lies on.
  Wall wall;
  // Whether the corner is at that wall's end (at the object's right when its back is on the wall).
  bool at_end;
};

struct InCorner {
  static constexpr int kObjects = 1;
  static constexpr bool kSeesZero = true;
  Footprint footprint;
  Side side;
  std::vector<RoomCorner> corners;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const {
    return LeastOf<T>(corners, frames, [this](const RoomCorner& corner, const auto& f) {
      // Walking along the wall with the room on the left, one runs against the side's outward normal turned left.
      const auto normal = NormalOf(f[0], side);
      const double half = (corner.at_end ? 1 : -1) * SideLength(footprint, side) / 2;
      const auto tip = MiddleOf(footprint, f[0], side) + half * Perpendicular(normal);
      return SquaredNorm(tip - Cast<std::decay_t<decltype(tip.x)>>(corner.point)) + TurnToWall(f[0], side, corner.wall);
    });
  }
};

std::vector<RoomCorner> CornersOf(const Room& room) {
  std::vector<RoomCorner> corners;
  for (size_t i = 0; i < room.walls.size(); ++i) {
    const Wall& before = room.walls[i];
    const Wall& after = room.walls[(i + 1) % room.walls.size()];
    if (Cross(before.Along(), after.Along()) <= 1e-6) continue;
    corners.push_back({before.end, before, true});
    corners.push_back({before.end, after, false});
  }
  return corners;
}

std::optional<Shortfall> InCornerShortfall(const PlacedCall& call) {
  const int object = call.object();
  return Worst({OffBy(call.Name(object), "the nearest corner that it fits", call.CostRoot())});
}

}  // namespace

ConstraintFacts InCornerFacts() {
  return {.name = "in_corner",
          .aliases = {"ind_in_corner", "io_in_corner"},
          .family = "wall",
          .summary = "`object` stands in a corner: the given side flush on one wall, a neighbouring side on the other.",
          .phrase = "stands in a corner",
          .doc =
              "cost = min over corners of the squared distance of the object's corner to the room's corner + (1 - cos "
              "angle) "
              "[m2]. The released function wants the object across the corner.",
          .parameters = {ObjectParameter("object", "What stands in the corner."),
                         SideParameter("side", "Its side on one of the two walls.", Side::kBack)},
          .sentences = {{"The plant is in a corner of the room.", "object=plant"},
                        {"The armchair stands in the corner.", "object=armchair"}},
          .layouts = {Satisfied("4x3 room; shelf 1x0.4 at 0.5,0.2,0", "object=shelf"),
                      Satisfied("4x3 room; shelf 1x0.4 at 0.2,0.5,270", "object=shelf"),
                      Satisfied("4x3 room; shelf 1x0.4 at 3.5,2.8,180", "object=shelf"),
                      Violated("4x3 room; shelf 1x0.4 at 0.8,0.2,0", "object=shelf"),
                      Violated("4x3 room; shelf 1x0.4 at 0.7,0.6,315", "object=shelf")},
          .shortfall = InCornerShortfall,
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            const int object = a.Object("object");
            return MakeCost(InCorner{FootprintOf(context, object), a.OneSide("side"), CornersOf(context.scene.room)},
                            {object});
          }};
}

}  // namespace flair::optimizer
