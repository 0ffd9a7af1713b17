// SPDX-License-Identifier: GPL-3.0-or-later
// Hangs a wall object in a zone.
//   cost = (zone cost of measure/outside.h) + (cost of on_wall, room/on_wall.h) [m2]
// Zero exactly when it hangs on a wall, its centre in the zone's Voronoi cell. The released on_wall_in_region is the
// first part; the second is there so that the call alone says all of its sentence.
#include <fmt/format.h>

#include <vector>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "optimizer_worker/constraints/measure/outside.h"
#include "optimizer_worker/constraints/room/on_wall.h"
#include "room/geometry/footprint.h"
#include "room/geometry/vec2.h"

namespace flair::optimizer {

namespace {

struct OnWallInZone {
  static constexpr int kObjects = 1;
  Footprint footprint;
  std::vector<HangingWall> places;
  std::vector<Vec2<double>> centers;
  int zone;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const {
    return SquaredBeyondBorders<T>(frames[0].center, centers, zone) +
           LeastOf<T>(places, frames,
                      [this](const HangingWall& place, const auto& f) { return HangsOn(footprint, f[0], place); });
  }
};

std::optional<Shortfall> OnWallInZoneShortfall(const PlacedCall& call) {
  const Zone& zone = call.scene().zones[static_cast<size_t>(call.arguments().Zone("zone"))];
  return Worst({OffBy(call.NameOf("object"), fmt::format("the {} zone", zone.name), call.CostRoot() / 2)});
}

}  // namespace

ConstraintFacts OnWallInZoneFacts() {
  return {.name = "on_wall_in_zone",
          .aliases = {"on_wall_in_region"},
          .family = "on_wall",
          .summary = "`object` hangs on a wall of `zone`.",
          .phrase = "hangs on a wall of the {zone} zone",
          .doc =
              "cost = zone cost as in_zone + cost of hanging on the best wall [m2]. The released function is the first "
              "part.",
          .parameters = {ObjectParameter("object", "What hangs."), ZoneParameter("zone", "Where.")},
          .sentences = {{"A painting hangs in the sleeping area.", "object=painting zone=sleeping"}},
          .layouts = {Satisfied("6x3 room; zone sleeping at 1,1; zone study at 5,1; art 0.6x0.04 at 2,0.02,0 wall",
                                "object=art zone=sleeping"),
                      Violated("6x3 room; zone sleeping at 1,1; zone study at 5,1; art 0.6x0.04 at 4,0.02,0 wall",
                               "object=art zone=sleeping"),
                      Violated("6x3 room; zone sleeping at 1,1; zone study at 5,1; art 0.6x0.04 at 2,1.2,10 wall",
                               "object=art zone=sleeping")},
          .shortfall = OnWallInZoneShortfall,
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            const int object = a.Object("object");
            const int zone = a.Zone("zone");
            if (static_cast<size_t>(zone) >= context.zone_centers.size()) {
              return absl::FailedPreconditionError("the zones have no places yet");
            }
            if (!HasPlace(context.zone_centers[static_cast<size_t>(zone)])) {
              return absl::FailedPreconditionError(fmt::format("nothing stands in zone \"{}\", so it has no place",
                                                               context.scene.zones[static_cast<size_t>(zone)].name));
            }
            return MakeCost(OnWallInZone{FootprintOf(context, object),
                                         HangingWalls(context.scene.room, context.scene.BottomOf(object),
                                                      context.scene.TopOf(object)),
                                         {context.zone_centers.begin(), context.zone_centers.end()},
                                         zone},
                            {object});
          }};
}

}  // namespace flair::optimizer
