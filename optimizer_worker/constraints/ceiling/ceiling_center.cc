// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/ceiling/ceiling_center.h"

#include "optimizer_worker/constraints/facts.h"

namespace flair::optimizer {

template <typename T>
T CeilingCenter::operator()(const Frames<T, 1>& frames) const {
  return SquaredNorm(frames[0].center - Cast<T>(room_center));
}

ConstraintFacts CeilingCenterFacts() {
  return {.name = "ceiling_center",
          .aliases = {"center_ceiling"},
          .family = "ceiling",
          .summary = "`object` hangs from the middle of the ceiling.",
          .doc = "cost = squared distance of its centre to the room's [m2], as released.",
          .parameters = {ObjectParameter("object", "What hangs.")},
          .sentences = {{"A chandelier hangs in the centre of the ceiling.", "object=chandelier"}},
          .layouts = {Satisfied("5x4 room; lamp 0.5x0.5 at 2.5,2,0 ceiling", "object=lamp"),
                      Violated("5x4 room; lamp 0.5x0.5 at 2.2,2.4,0 ceiling", "object=lamp")},
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            return MakeCost(CeilingCenter{Centroid(context.scene.room.floor)}, {a.Object("object")});
          }};
}

}  // namespace flair::optimizer
