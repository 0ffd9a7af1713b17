// SPDX-License-Identifier: GPL-3.0-or-later
// Puts an object under a window.
//   cost = min over windows of  out(gap, [0, 0.1])^2 + max(|offset| - |L - w| / 2, 0)^2 + (1 - cos a)          [m2]
//   gap     distance of the object's side that looks at the wall, offset  of that side's middle from the window's
//   middle L, w    lengths of that side and of the window;  a  angle between side and wall
// Zero exactly when the object stands at the wall (within 10 cm), square to it, its side within the window's interval
// or the other way round. The released ind_under_window reaches zero only with the centre on the wall (SEMANTICS.md
// section 3).
#include <cmath>
#include <vector>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "optimizer_worker/constraints/measure/gap.h"
#include "optimizer_worker/constraints/measure/walls.h"
#include "room/geometry/footprint.h"
#include "room/scene/room.h"

namespace flair::optimizer {

namespace {

// A window as an interval of its wall.
struct WindowPlace {
  Wall wall;
  double middle_m;
  double width_m;
};

struct UnderWindow {
  static constexpr int kObjects = 1;
  static constexpr bool kSeesZero = true;
  Footprint footprint;
  std::vector<WindowPlace> windows;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const {
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
};

std::optional<Shortfall> UnderWindowShortfall(const PlacedCall& call) {
  return Worst({OffBy(call.NameOf("object"), "its place under the nearest window", call.CostRoot())});
}

}  // namespace

ConstraintFacts UnderWindowFacts() {
  return {
      .name = "under_window",
      .aliases = {"ind_under_window", "io_under_window"},
      .family = "feature",
      .summary = "`object` stands at the wall under a window, within its width (or around it when wider).",
      .phrase = "stands under a window",
      .doc =
          "cost = min over windows of squared gap beyond 0.1 m + squared slide out of the window's interval + (1 - cos "
          "angle) [m2]. The released function wants the centre on the wall.",
      .parameters = {ObjectParameter("object", "What stands there.")},
      .sentences = {{"The desk is under the window.", "object=desk"}},
      .layouts = {Satisfied("4x3 room; window south 1 1; desk 1.2x0.6 at 1.45,0.3,0", "object=desk"),
                  Satisfied("4x3 room; window east 1 1.5; desk 1.2x0.6 at 3.65,1.7,270", "object=desk"),
                  Violated("4x3 room; window south 1 1; desk 1.2x0.6 at 2.2,0.6,5", "object=desk")},
      .shortfall = UnderWindowShortfall,
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
