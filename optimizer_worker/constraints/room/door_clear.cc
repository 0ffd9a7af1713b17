// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/room/door_clear.h"

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/measure/floor_shape.h"
#include "optimizer_worker/constraints/measure/gap.h"
#include "optimizer_worker/constraints/whole_room.h"
#include "room/scene/room.h"

namespace flair::optimizer {

std::vector<ConvexPiece> SwingPieces(const Room& room) {
  std::vector<ConvexPiece> swings;
  for (const Opening& opening : room.openings) {
    for (const Polygon& swing : ConvexSwingAreas(room, opening)) {
      swings.push_back(AreaAtWall(swing, room.walls[static_cast<size_t>(opening.wall)]));
    }
  }
  return swings;
}

std::vector<ConvexPiece> DoorAreas(const Room& room, double passage_m) {
  std::vector<ConvexPiece> areas = SwingPieces(room);
  for (const Opening& opening : room.openings) {
    if (opening.kind != OpeningKind::kDoor) continue;
    areas.push_back(AreaAtWall(PassageArea(room, opening, passage_m), room.walls[static_cast<size_t>(opening.wall)]));
  }
  return areas;
}

template <typename T>
T DoorClearFormula::operator()(const Frames<T, 1>& frames) const {
  const Box<T> box(footprint, frames[0]);
  T sum(0.0);
  for (const ConvexPiece& area : areas) sum += SquaredPenetration<T>(box, area);
  return sum;
}

std::unique_ptr<Cost> DoorClear(const Scene& scene, int object) {
  const Object& o = scene.objects[static_cast<size_t>(object)];
  std::vector<ConvexPiece> areas = DoorAreas(scene.room);
  // Doors pass over rugs and under lamps; things on tables are where the tables are.
  constexpr double kHeadroom_m = 2;
  const bool out_of_the_way = o.walk_over || o.kind == ObjectKind::kSurface ||
                              (o.kind != ObjectKind::kFloor && scene.BottomOf(object) >= kHeadroom_m);
  if (areas.empty() || out_of_the_way || o.kind == ObjectKind::kCeiling) return nullptr;
  return MakeCost(DoorClearFormula{o.footprint, std::move(areas)}, {object});
}

ConstraintFacts DoorClearFacts() {
  return {
      .name = "door_clear",
      .family = "room",
      .summary = "`object` is out of the swing of every door and of the passage in front of it.",
      .doc =
          "cost = sum over doors of squared penetration of the sector that the leaf sweeps and of a passage 0.6 m deep "
          "[m2]. The released term uses a square twice as wide as the door.",
      .parameters = {ObjectParameter("object", "What is to stay out of the way.")},
      .layouts = {Satisfied("4x3 room; door south 1 0.9; box 1x1 at 0.5,0.5,0", "object=box"),
                  Satisfied("4x3 room; door south 1 0.9; box 0.2x0.2 at 1.85,0.85,0", "object=box"),
                  Satisfied("4x3 room; door south 1 0.9; box 0.5x0.5 at 2.2,0.25,0", "object=box"),
                  Violated("4x3 room; door south 1 0.9; box 1x1 at 1.2,0.9,10", "object=box"),
                  Violated("4x3 room; door south 1 0.9; box 0.6x0.4 at 1.9,0.2,0", "object=box"),
                  Violated("4x3 room; door east 1 0.9 hinge_end outward; box 1x1 at 3.3,1.5,0", "object=box")},
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        std::unique_ptr<Cost> cost = DoorClear(context.scene, a.Object("object"));
        if (cost != nullptr) return cost;
        return absl::FailedPreconditionError("no door of this room can be blocked by this object");
      },
      .built_in = true};
}

}  // namespace flair::optimizer
