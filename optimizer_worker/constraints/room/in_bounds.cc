// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps an object on the floor.
//   cost = sum over corners C and half-planes of the floor's hull of max(-h(C), 0)^2 + sum over pockets of depth^2 [m2]
//   h(C)   signed distance of the corner from the half-plane's edge, positive inside
//   depth  penetration of the rectangle into a part of the hull that is not floor (none in a rectangle)
// Zero exactly when the whole rectangle is on the floor. For a rectangular room [Paper] Eq. in_bounds: the released
// function is 10 times this. The weight is the solver's.
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/floor_shape.h"
#include "optimizer_worker/constraints/whole_room.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

namespace {

struct InBoundsFormula {
  static constexpr int kObjects = 1;
  static constexpr bool kSeesZero = true;
  Footprint footprint;
  FloorShape floor;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const {
    return floor.SquaredExcess(Box<T>(footprint, frames[0]));
  }
};

}  // namespace

std::unique_ptr<Cost> InBounds(const Scene& scene, int object) {
  return MakeCost(InBoundsFormula{scene.objects[static_cast<size_t>(object)].footprint, FloorShape(scene.room.floor)},
                  {object});
}

ConstraintFacts InBoundsFacts() {
  return {
      .name = "in_bounds",
      .family = "room",
      .summary = "`object` is wholly on the floor of the room.",
      .doc =
          "cost = sum over corners of the squared distance beyond each wall [m2], plus squared penetration of inner "
          "corners in rooms that are not convex. The paper's in-bounds term; the released function has a factor 10.",
      .parameters = {ObjectParameter("object", "What is to stay inside.")},
      .layouts = {Satisfied("4x3 room; box 1x1 at 0.5,0.5,90", "object=box"),
                  Satisfied("room 0,0 4,0 4,2 2,2 2,4 0,4; box 1x1 at 1.5,3,0", "object=box"),
                  Satisfied("room 0,0 4,0 4,2 2,2 2,4 0,4; box 1x1 at 3,1.5,0", "object=box"),
                  Violated("4x3 room; box 1x1 at 0.4,0.5,10", "object=box"),
                  Violated("room 0,0 4,0 4,2 2,2 2,4 0,4; box 1x1 at 1.8,2.3,0", "object=box"),
                  Violated("room 0,0 4,0 4,2 2,2 2,4 0,4; box 1x0.4 at 3,3,20", "object=box")},
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        return InBounds(context.scene, a.Object("object"));
      },
      .built_in = true};
}

}  // namespace flair::optimizer
