// SPDX-License-Identifier: GPL-3.0-or-later
// Hangs an object from the middle of the ceiling: cost = |c - c_room|^2 [m2], as the released center_ceiling. The
// room's centre is its centre of mass. Zero exactly there.
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/vec2.h"

namespace flair::optimizer {

namespace {

struct CeilingCenter {
  static constexpr int kObjects = 1;
  Vec2<double> room_center;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const {
    return SquaredNorm(frames[0].center - Cast<T>(room_center));
  }
};

std::optional<Shortfall> CeilingCenterShortfall(const PlacedCall& call) {
  return Worst({OffBy(call.NameOf("object"), "the middle of the ceiling", call.CostRoot())});
}

}  // namespace

ConstraintFacts CeilingCenterFacts() {
  return {.name = "ceiling_center",
          .aliases = {"center_ceiling"},
          .family = "ceiling",
          .summary = "`object` hangs from the middle of the ceiling.",
          .phrase = "hangs from the middle of the ceiling",
          .doc = "cost = squared distance of its centre to the room's [m2], as released.",
          .parameters = {ObjectParameter("object", "What hangs.")},
          .sentences = {{"A chandelier hangs in the centre of the ceiling.", "object=chandelier"}},
          .layouts = {Satisfied("5x4 room; lamp 0.5x0.5 at 2.5,2,0 ceiling", "object=lamp"),
                      Violated("5x4 room; lamp 0.5x0.5 at 2.2,2.4,0 ceiling", "object=lamp")},
          .shortfall = CeilingCenterShortfall,
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            return MakeCost(CeilingCenter{Centroid(context.scene.room.floor)}, {a.Object("object")});
          }};
}

}  // namespace flair::optimizer
