// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/room/on_wall.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/measure/beside.h"
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

Shortfall NotHanging(const PlacedCall& call, int object) {
  const Scene& scene = call.scene();
  double least = std::numeric_limits<double>::infinity();
  for (const HangingWall& place : HangingWalls(scene.room, scene.BottomOf(object), scene.TopOf(object))) {
    least = std::min(least, HangsOn(call.FootprintOf(object), call.FrameOf(object), place));
  }
  return OffBy(call.Name(object), "a place flat on one wall, clear of its doors and windows",
               std::isfinite(least) ? std::sqrt(least) : 0);
}

std::vector<Shortfall> OffBeside(const PlacedCall& call, double most_along_m, double most_away_m, const char* place) {
  const int object = call.object(), target = call.target();
  const Wall& wall = call.BestWall(
      [&](const Wall& w) { return SideOnWall(call.FootprintOf(object), call.FrameOf(object), Side::kBack, w); });
  const WallView<double> view(call.FootprintOf(target), call.FrameOf(target), wall);
  const double offset = wall.Offset(call.FrameOf(object).center);
  const bool above = most_along_m == 0;
  const double along =
      above ? std::abs(offset - view.Middle()) : std::max({0.0, view.low - offset, offset - view.high});
  return {
      {fmt::format("{} hangs {:.2f} m along the wall from {} {}", call.Name(object), along, place, call.Name(target)),
       along - most_along_m, "m"},
      TooFar(call.Name(target), fmt::format("{}, where {} hangs", WallName(wall), call.Name(object)), view.distance,
             most_away_m),
      NotHanging(call, object)};
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
