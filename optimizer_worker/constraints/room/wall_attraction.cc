// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps objects from floating in the middle of the room without reason.
//   cost = max(d - r - T, 0)^2                                                                     [m2]
//   d  distance of the object's centre to the nearest wall, r half its diagonal, T = 0.5 m
// [Paper] Eq. wall_attraction without its factor 1/lambda_2. Zero exactly when the object is within T of a wall. The
// released term also asks for the back to be the nearest side; that is against_wall's matter.
#include <cmath>
#include <vector>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "optimizer_worker/constraints/whole_room.h"
#include "room/scene/room.h"

namespace flair::optimizer {

namespace {

struct WallAttractionFormula {
  static constexpr int kObjects = 1;
  static constexpr bool kSeesZero = true;
  std::vector<Wall> walls;
  // r + T.
  double free_m;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const {
    return LeastOf<T>(walls, frames, [this](const Wall& wall, const auto& f) {
      const auto& center = f[0].center;
      // Beyond the ends of a wall its end counts.
      const auto height = wall.Height(center);
      const auto beyond = SquaredOutside(wall.Offset(center), 0, wall.length_m);
      using std::sqrt;
      if (ValueOf(beyond) == 0) return SquaredHinge(Magnitude(height) - free_m);
      return SquaredHinge(sqrt(height * height + beyond) - free_m);
    });
  }
};

}  // namespace

std::unique_ptr<Cost> WallAttraction(const Scene& scene, int object) {
  const Footprint& f = scene.objects[static_cast<size_t>(object)].footprint;
  constexpr double kThreshold_m = 0.5;
  return MakeCost(WallAttractionFormula{scene.room.walls, std::hypot(f.width_m, f.depth_m) / 2 + kThreshold_m},
                  {object});
}

ConstraintFacts WallAttractionFacts() {
  return {
      .name = "wall_attraction",
      .family = "room",
      .summary = "`object` is not further than half a metre from some wall.",
      .doc =
          "cost = max(distance of the centre to the nearest wall - half diagonal - 0.5 m, 0)^2 [m2]. The paper's wall "
          "attraction without its factor 1/20.",
      .parameters = {ObjectParameter("object", "What is drawn to the walls.")},
      .layouts = {Satisfied("6x6 room; box 1x1 at 1.2,3,0", "object=box"),
                  Violated("6x6 room; box 1x1 at 3,2.8,0", "object=box")},
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        return WallAttraction(context.scene, a.Object("object"));
      },
      .built_in = true};
}

}  // namespace flair::optimizer
