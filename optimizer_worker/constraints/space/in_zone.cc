// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/space/in_zone.h"

#include <fmt/format.h>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/measure/outside.h"
#include "optimizer_worker/constraints/whole_room.h"

namespace flair::optimizer {

template <typename T>
T InZone::operator()(const Frames<T, 1>& frames) const {
  return SquaredBeyondBorders<T>(frames[0].center, centers, zone);
}

std::unique_ptr<Cost> ZoneAffinity(const Scene& scene, int object, std::span<const Vec2<double>> zone_centers) {
  const int zone = scene.objects[static_cast<size_t>(object)].zone;
  if (zone < 0 || zone_centers.size() < 2 || !HasPlace(zone_centers[static_cast<size_t>(zone)])) return nullptr;
  return MakeCost(InZone{{zone_centers.begin(), zone_centers.end()}, zone}, {object});
}

namespace {

std::optional<Shortfall> InZoneShortfall(const PlacedCall& call) {
  const Zone& zone = call.scene().zones[static_cast<size_t>(call.arguments().Zone("zone"))];
  return Worst({OffBy(call.NameOf("object"), fmt::format("the {} zone", zone.name), call.CostRoot() / 2)});
}

}  // namespace

ConstraintFacts InZoneFacts() {
  return {
      .name = "in_zone",
      .aliases = {"ind_in_region", "io_in_region"},
      .family = "space",
      .summary = "The centre of `object` is in `zone`: nearer to that zone's middle than to any other's.",
      .phrase = "stands in the {zone} zone",
      .doc =
          "cost = sum over other zones of max(distance to the own zone's mean point - distance to theirs, 0)^2 "
          "[m2]. As "
          "released, without its factor 5.",
      .parameters = {ObjectParameter("object", "What is to be there."), ZoneParameter("zone", "Where.")},
      .sentences = {{"The wardrobe is in the dressing area.", "object=wardrobe zone=dressing"}},
      .layouts = {Satisfied("6x3 room; zone sleeping at 1,1; zone study at 5,1; bed 1x2 at 2.9,1,0",
                            "object=bed zone=sleeping"),
                  Violated("6x3 room; zone sleeping at 1,1; zone study at 5,1; bed 1x2 at 3.4,1,0",
                           "object=bed zone=sleeping")},
      .shortfall = InZoneShortfall,
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        const int zone = a.Zone("zone");
        if (static_cast<size_t>(zone) >= context.zone_centers.size()) {
          return absl::FailedPreconditionError("the zones have no places yet");
        }
        if (!HasPlace(context.zone_centers[static_cast<size_t>(zone)])) {
          return absl::FailedPreconditionError(fmt::format("nothing stands in zone \"{}\", so it has no place",
                                                           context.scene.zones[static_cast<size_t>(zone)].name));
        }
        return MakeCost(InZone{{context.zone_centers.begin(), context.zone_centers.end()}, zone}, {a.Object("object")});
      }};
}

}  // namespace flair::optimizer
