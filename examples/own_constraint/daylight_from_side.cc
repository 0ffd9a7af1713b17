// SPDX-License-Identifier: GPL-3.0-or-later
// Lets daylight fall on an object from its left or right, as on a desk: a window ahead dazzles, one behind is mirrored
// by the screen.
//   cost = min over windows and both sides of
//          max(1 - cos a - (1 - cos 30 deg), 0)^2 + out(u, window +- L / 2)^2 + out(h, [0, max_distance_m])^2    [m2]
//   a     angle between the side's outward normal and the straight look at the window's wall; its term has no unit
//   u, h  of the side's middle: metres along the wall, and from it;  L  length of the side
//   out(x, interval)  how far x is outside of it
// Zero exactly when one of the two sides looks at a window within 30 degrees, lies before it at least by its edge and
// is at most max_distance_m from its wall. Continuously differentiable but where another window or side takes over.
#include <vector>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "optimizer_worker/constraints/measure/walls.h"
#include "room/autodiff/dual.h"
#include "room/geometry/polygon.h"
#include "room/scene/room.h"

namespace flair::optimizer {
namespace {

// One way for the light: through a window, an interval of its wall, onto a side.
struct Light {
  Wall wall;
  double start_m;
  double end_m;
  Side side;
};

BoundCost BindDaylightFromSide(const Arguments& a, const BindContext& context) {
  const int object = a.Object("object");
  const Room& room = context.scene.room;
  std::vector<Light> lights;
  for (const Opening& opening : room.openings) {
    if (opening.kind != OpeningKind::kWindow) continue;
    for (const Side side : {Side::kLeft, Side::kRight}) {
      lights.push_back(
          {room.walls[static_cast<size_t>(opening.wall)], opening.offset_m, opening.offset_m + opening.width_m, side});
    }
  }
  if (lights.empty()) return absl::FailedPreconditionError("the room has no window");
  const auto formula = [lights, footprint = FootprintOf(context, object),
                        max_m = a.Number("max_distance_m")]<typename T>(const Frames<T, 1>& frames) {
    return LeastOf<T>(lights, frames, [&](const Light& light, const auto& f) {
      constexpr double kPlay = 0.1339745962155614;  // 1 - cos of 30 degrees
      const double reach_m = SideLength(footprint, light.side) / 2;
      const auto middle = MiddleOf(footprint, f[0], light.side);
      return SquaredHinge(TurnToWall(f[0], light.side, light.wall) - kPlay) +
             SquaredOutside(light.wall.Offset(middle), light.start_m - reach_m, light.end_m + reach_m) +
             SquaredOutside(light.wall.Height(middle), 0, max_m);
    });
  };
  return MakeCost<kSeesZero>({object}, formula);
}

}  // namespace

ConstraintCode DaylightFromSideCode() { return {"daylight_from_side", BindDaylightFromSide}; }

}  // namespace flair::optimizer
