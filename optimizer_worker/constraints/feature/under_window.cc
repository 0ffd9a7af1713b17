// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/feature/under_window.h"

#include <cmath>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "optimizer_worker/constraints/measure/gap.h"
#include "optimizer_worker/constraints/measure/walls.h"

namespace flair::optimizer {

template <typename T>
T UnderWindow::operator()(const Frames<T, 1>& frames) const {
  return LeastOf<T>(windows, frames, [this](const WindowPlace& window, const auto& f) {
    constexpr double kAir_m = 0.1;
    const Side side = SideTowards(ValueOf(f[0].front), window.wall);
    const auto middle = MiddleOf(footprint, f[0], side);
    const double play = std::abs(SideLength(footprint, side) - window.width_m) / 2;
    return SquaredOutside(window.wall.Height(middle), 0, kAir_m) +
           SquaredOutside(window.wall.Offset(middle) - window.middle_m, -play, play) +
           TurnToWall(f[0], side, window.wall);
  });
}

ConstraintFacts UnderWindowFacts() {
  return {
      .name = "under_window",
      .aliases = {"ind_under_window", "io_under_window"},
      .family = "feature",
      .summary = "`object` stands at the wall under a window, within its width (or around it when wider).",
      .doc =
          "cost = min over windows of squared gap beyond 0.1 m + squared slide out of the window's interval + (1 - cos "
          "angle) [m2]. The released function wants the centre on the wall.",
      .parameters = {ObjectParameter("object", "What stands there.")},
      .sentences = {{"The desk is under the window.", "object=desk"}},
      .layouts = {Satisfied("4x3 room; window south 1 1; desk 1.2x0.6 at 1.45,0.3,0", "object=desk"),
                  Satisfied("4x3 room; window east 1 1.5; desk 1.2x0.6 at 3.65,1.7,270", "object=desk"),
                  Violated("4x3 room; window south 1 1; desk 1.2x0.6 at 2.2,0.6,5", "object=desk")},
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        const int object = a.Object("object");
        UnderWindow formula{FootprintOf(context, object), {}};
        for (const Opening& o : context.scene.room.openings) {
          if (o.kind != OpeningKind::kWindow) continue;
          formula.windows.push_back(
              {context.scene.room.walls[static_cast<size_t>(o.wall)], o.offset_m + o.width_m / 2, o.width_m});
        }
        if (formula.windows.empty()) return absl::FailedPreconditionError("the room has no window");
        return MakeCost(std::move(formula), {object});
      }};
}

}  // namespace flair::optimizer
