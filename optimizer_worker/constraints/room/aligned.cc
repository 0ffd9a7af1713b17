// SPDX-License-Identifier: GPL-3.0-or-later
// Weakly prefers headings along the room's axes: cost = sin^2(2 theta) / 5, [Paper] Eq. aligned, as released.
// In a room that is not an upright rectangle theta is measured from its longest wall. Zero at every quarter turn.
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/whole_room.h"

namespace flair::optimizer {

namespace {

struct AlignedFormula {
  static constexpr int kObjects = 1;
  // Unit vector along the longest wall.
  Vec2<double> axis;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const {
    const Vec2<T> along = Cast<T>(axis);
    // sin(2 a) = 2 sin(a) cos(a), a from the axis to the object's right.
    const T sine2 = T(2.0) * Cross(along, frames[0].right) * Dot(along, frames[0].right);
    return sine2 * sine2 * T(0.2);
  }
};

}  // namespace

std::unique_ptr<Cost> Aligned(const Scene& scene, int object) {
  AlignedFormula formula{{1, 0}};
  double longest = 0;
  for (const Wall& wall : scene.room.walls) {
    if (wall.length_m > longest) longest = wall.length_m, formula.axis = wall.Along();
  }
  return MakeCost(formula, {object});
}

ConstraintFacts AlignedFacts() {
  return {.name = "aligned",
          .family = "room",
          .summary = "`object` is parallel to the walls.",
          .doc = "cost = sin^2(2 theta) / 5, theta from the longest wall. The paper's alignment term, as released.",
          .parameters = {ObjectParameter("object", "What is to be parallel.")},
          .layouts = {Satisfied("4x3 room; box 1x1 at 2,1,270", "object=box"),
                      Violated("4x3 room; box 1x1 at 2,1,30", "object=box")},
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            return Aligned(context.scene, a.Object("object"));
          },
          .built_in = true};
}

}  // namespace flair::optimizer
