// SPDX-License-Identifier: GPL-3.0-or-later
#include "examples/own_constraint/daylight_from_side.h"

#include <utility>

#include "optimizer_worker/autodiff/smooth.h"
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "optimizer_worker/constraints/measure/walls.h"

namespace flair::optimizer {

template <typename T>
T DaylightFromSide::operator()(const Frames<T, 1>& frames) const {
  return LeastOf<T>(lights, frames, [this](const Light& light, const auto& f) {
    constexpr double kPlay = 0.1339745962155614;  // 1 - cos of 30 degrees
    const double reach_m = SideLength(footprint, light.side) / 2;
    const auto middle = MiddleOf(footprint, f[0], light.side);
    return SquaredHinge(TurnToWall(f[0], light.side, light.wall) - kPlay) +
           SquaredOutside(light.wall.Offset(middle), light.start_m - reach_m, light.end_m + reach_m) +
           SquaredOutside(light.wall.Height(middle), 0, max_distance_m);
  });
}

ConstraintFacts DaylightFromSideFacts() {
  return {
      .name = "daylight_from_side",
      .family = "feature",
      .summary = "Daylight falls on `object` from its left or right: one of these sides is before a window.",
      .doc =
          "cost = min over windows and both sides of squared excess of 1 - cos angle over that of 30 degrees + squared "
          "distance between side and window along the wall + squared excess of that from the wall over max_distance_m "
          "[m2].",
      .parameters = {ObjectParameter("object", "What the light falls on."),
                     LengthParameter("max_distance_m", "Largest distance of that side from the window's wall.", 0, 20,
                                     1.5)},
      .sentences = {{"Daylight falls on the desk from the side.", "object=desk"},
                    {"The easel stands sideways to the window, at most a metre away.",
                     "object=easel max_distance_m=1"}},
      .layouts = {Satisfied("4x3 room; window south 1 1; desk 1.2x0.6 at 1.5,1.2,90", "object=desk"),
                  Satisfied("4x3 room; window east 1 1; desk 1.2x0.6 at 2.8,1.4,20", "object=desk"),
                  Violated("4x3 room; window south 1 1; desk 1.2x0.6 at 1.5,1.2,0", "object=desk"),
                  Violated("4x3 room; window south 1 1; desk 1.2x0.6 at 3.3,1.2,90", "object=desk"),
                  Violated("4x3 room; window south 1 1; desk 1.2x0.6 at 1.5,2,90", "object=desk max_distance_m=1")},
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        const int object = a.Object("object");
        DaylightFromSide formula{FootprintOf(context, object), {}, a.Number("max_distance_m")};
        const Room& room = context.scene.room;
        for (const Opening& opening : room.openings) {
          if (opening.kind != OpeningKind::kWindow) continue;
          for (const Side side : {Side::kLeft, Side::kRight}) {
            formula.lights.push_back({room.walls[static_cast<size_t>(opening.wall)], opening.offset_m,
                                      opening.offset_m + opening.width_m, side});
          }
        }
        if (formula.lights.empty()) return absl::FailedPreconditionError("the room has no window");
        return MakeCost(std::move(formula), {object});
      }};
}

}  // namespace flair::optimizer
