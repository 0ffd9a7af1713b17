// SPDX-License-Identifier: GPL-3.0-or-later
// Sets a thing on the middle of another: cost = |c1 - c2|^2 + (1 - cos(theta_1 - theta_2)) [m2]. Zero exactly when the
// centres meet and both face the same way. The released on_top_central compares headings that wrap.
#include "optimizer_worker/autodiff/smooth.h"
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"

namespace flair::optimizer {

namespace {

struct OnTopCenter {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const {
    return SquaredNorm(frames[0].center - frames[1].center) + Turn(frames[0].front, frames[1].front);
  }
};

std::optional<Shortfall> OnTopCenterShortfall(const PlacedCall& call) {
  const int object = call.object(), host = call.arguments().Object("host");
  if (const std::optional<Shortfall> off = OffMiddle(call, object, host)) return off;
  return Worst({Turned(call.Name(object), "the direction of " + call.Name(host),
                       AngleOf(call.FrameOf(object).front, call.FrameOf(host).front))});
}

}  // namespace

ConstraintFacts OnTopCenterFacts() {
  return {.name = "on_top_center",
          .aliases = {"on_top_central"},
          .family = "surface",
          .summary = "`object` stands on the middle of `host`, facing the same way.",
          .phrase = "stands in the middle of {host}",
          .doc = "cost = squared distance of the centres + (1 - cos of the difference of headings) [m2].",
          .parameters = {ObjectParameter("object", "What is set down."), ObjectParameter("host", "What carries it.")},
          .sentences = {{"A lamp stands on the nightstand.", "object=lamp host=nightstand"}},
          .layouts = {Satisfied("5x4 room; desk 1.2x0.6 at 2,2,90; lamp 0.2x0.2 at 2,2,90 surface on desk",
                                "object=lamp host=desk"),
                      Violated("5x4 room; desk 1.2x0.6 at 2,2,90; lamp 0.2x0.2 at 2.1,2.3,40 surface on desk",
                               "object=lamp host=desk")},
          .shortfall = OnTopCenterShortfall,
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            return MakeCost(OnTopCenter{}, {a.Object("object"), a.Object("host")});
          }};
}

}  // namespace flair::optimizer
