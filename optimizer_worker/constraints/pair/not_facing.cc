// SPDX-License-Identifier: GPL-3.0-or-later
// Turns an object away from another: cost = max(cos a - cos 45, 0)^2, a the angle between its front and the direction
// from its centre to the target's. Zero exactly when the target is at least 45 degrees off its look. The released
// io_not_facing is identically zero (SEMANTICS.md section 4).
#include <fmt/format.h>

#include "optimizer_worker/autodiff/smooth.h"
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {

namespace {

struct NotFacing {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const {
    constexpr double kCos45 = 0.70710678118654757;
    const Vec2<T> to_target = frames[1].center - frames[0].center;
    constexpr double kNoDirection_m2 = 1e-8;
    if (ValueOf(SquaredNorm(to_target)) < kNoDirection_m2) return T(0.0);
    return SquaredHinge(Dot(frames[0].front, to_target) / Length(to_target) - kCos45);
  }
};

std::optional<Shortfall> NotFacingShortfall(const PlacedCall& call) {
  const Frame<double> frame = call.FrameOf(call.object());
  const double angle = AngleOf(frame.front, call.FrameOf(call.target()).center - frame.center);
  const double missed_deg = 45 - angle * 180 / kPi;
  return Worst({{fmt::format("{} looks within {:.0f} degrees of {}, at least 45", call.NameOf("object"),
                             angle * 180 / kPi, call.NameOf("target")),
                 missed_deg, "deg"}});
}

}  // namespace

ConstraintFacts NotFacingFacts() {
  return {.name = "not_facing",
          .aliases = {"io_not_facing", "p_not_facing", "ind_not_facing"},
          .family = "pair",
          .summary = "`object` does not look at `target`, which is at least 45 degrees off its front.",
          .phrase = "does not look at {target}",
          .doc =
              "cost = max(cos(angle between front and direction to the target) - cos 45, 0)^2. The released function "
              "is always "
              "zero.",
          .parameters = {ObjectParameter("object", "What looks elsewhere."),
                         ObjectParameter("target", "What is not looked at.")},
          .sentences = {{"The bed does not face the mirror.", "object=bed target=mirror"},
                        {"The desk is turned away from the bed.", "object=desk target=bed"}},
          .layouts = {Satisfied("5x4 room; a 1x1 at 1,1,0; b 1x1 at 3,1,0", "object=a target=b"),
                      Violated("5x4 room; a 1x1 at 1,1,0; b 1x1 at 1.5,3,0", "object=a target=b")},
          .shortfall = NotFacingShortfall,
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            return MakeCost(NotFacing{}, {a.Object("object"), a.Object("target")});
          }};
}

}  // namespace flair::optimizer
