// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/room/on_wall.h"

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "optimizer_worker/constraints/whole_room.h"

namespace flair::optimizer {

std::vector<HangingWall> HangingWalls(const Room& room, double bottom_m, double top_m) {
  std::vector<HangingWall> places;
  for (const Wall& wall : room.walls) places.push_back({wall, {}});
  for (const Opening& opening : room.openings) {
    if (opening.sill_height_m >= top_m || opening.head_height_m <= bottom_m) continue;
    places[static_cast<size_t>(opening.wall)].blocked.push_back({opening.offset_m, opening.offset_m + opening.width_m});
  }
  return places;
}

template <typename T>
T OnWallFormula::operator()(const Frames<T, 1>& frames) const {
  return LeastOf<T>(places, frames,
                    [this](const HangingWall& place, const auto& f) { return HangsOn(footprint, f[0], place); });
}

std::unique_ptr<Cost> OnWall(const Scene& scene, int object) {
  const Object& o = scene.objects[static_cast<size_t>(object)];
  if (o.kind != ObjectKind::kWall) return nullptr;
  return MakeCost(OnWallFormula{o.footprint, HangingWalls(scene.room, scene.BottomOf(object), scene.TopOf(object))},
                  {object});
}

ConstraintFacts OnWallFacts() {
  return {.name = "on_wall",
          .family = "room",
          .summary = "`object`, a wall object, hangs flush on one wall and off its doors and windows.",
          .doc =
              "cost = min over walls of gap^2 + (1 - cos angle) + overhang^2 + squared slides off openings whose "
              "heights meet "
              "the object's [m2]. The paper multiplies over all walls and does not reduce headings.",
          .parameters = {ObjectParameter("object", "What hangs.")},
          .layouts = {Satisfied("4x3 room; window south 1 1; art 0.6x0.04 at 0.6,0.02,0 wall height 0.5 elevation 1.3",
                                "object=art"),
                      Satisfied("4x3 room; window south 1 1 sill 1 head 2; art 0.6x0.04 at 1.5,0.02,0 wall height 0.5 "
                                "elevation 2.2",
                                "object=art"),
                      Violated("4x3 room; window south 1 1 sill 1 head 2; art 0.6x0.04 at 1.2,0.02,0 wall height 0.5 "
                               "elevation 1.3",
                               "object=art"),
                      Violated("4x3 room; art 0.6x0.04 at 0.6,0.52,15 wall height 0.5 elevation 1.3", "object=art")},
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            std::unique_ptr<Cost> cost = OnWall(context.scene, a.Object("object"));
            if (cost != nullptr) return cost;
            return absl::FailedPreconditionError("the object does not hang on walls");
          },
          .built_in = true};
}

}  // namespace flair::optimizer
