// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/room/zone_affinity.h"

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/whole_room.h"

namespace flair::optimizer {

ConstraintFacts ZoneAffinityFacts() {
  return {.name = "zone",
          .family = "room",
          .summary = "`object` is in the zone that it belongs to.",
          .doc = "cost as in_zone, for the object's own zone [m2]. The paper's zoning term.",
          .parameters = {ObjectParameter("object", "What is to be in its zone.")},
          .layouts = {Satisfied("6x3 room; zone sleeping at 1,1; zone study at 5,1; bed 1x2 at 2,1,0 zone sleeping",
                                "object=bed"),
                      Violated("6x3 room; zone sleeping at 1,1; zone study at 5,1; bed 1x2 at 4,1,0 zone sleeping",
                               "object=bed")},
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            std::unique_ptr<Cost> cost = ZoneAffinity(context.scene, a.Object("object"), context.zone_centers);
            if (cost != nullptr) return cost;
            return absl::FailedPreconditionError("the object has no zone, or there is one zone only");
          },
          .built_in = true};
}

}  // namespace flair::optimizer
