// SPDX-License-Identifier: GPL-3.0-or-later
// Sets a thing on one corner of another.
//   cost = overhang^2 + max(-s_u u, 0)^2 + max(-s_v v, 0)^2 + (1 - cos(theta_1 - theta_2))                      [m2]
//   u, v      its centre in the host's frame;  s_u, s_v  signs of the corner
//   overhang  of its corners over the host's edges (measure/outside.h); of its centre when it is too large to fit
// Zero exactly when it stands wholly on the host, its centre in that quarter, facing the same way. The released
// on_top_corner pulls to the point half way to the corner and forgets things that do not touch the host.
#include <fmt/format.h>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/outside.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

namespace {

struct OnTopCorner {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;
  Footprint object;
  Footprint host;
  Vec2<double> signs;
  bool fits;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const {
    const Vec2<T> p = frames[1].ToObject(frames[0].center);
    const T overhang = fits ? SquaredSticksOut(object, frames[0], host, frames[1])
                            : SquaredSticksOut(Footprint{}, frames[0], host, frames[1]);
    return overhang + SquaredHinge(-signs.x * p.x) + SquaredHinge(-signs.y * p.y) +
           Turn(frames[0].front, frames[1].front);
  }
};

Vec2<double> SignsOf(Corner corner) {
  const bool right = corner == Corner::kBackRight || corner == Corner::kFrontRight;
  const bool front = corner == Corner::kFrontLeft || corner == Corner::kFrontRight;
  return {right ? 1.0 : -1.0, front ? 1.0 : -1.0};
}

std::optional<Shortfall> OnTopCornerShortfall(const PlacedCall& call) {
  std::string corner(CornerName(call.arguments().OneCorner("corner")));
  for (char& c : corner) c = c == '_' ? ' ' : c;
  return Worst(
      {OffBy(call.NameOf("object"), fmt::format("the {} corner of {}", corner, call.NameOf("host")), call.CostRoot())});
}

}  // namespace

ConstraintFacts OnTopCornerFacts() {
  return {.name = "on_top_corner",
          .family = "surface",
          .summary = "`object` stands on `host`, in the quarter of the given corner, facing the same way.",
          .phrase = "stands at the {corner} corner of {host}",
          .doc =
              "cost = squared overhang + squared distance outside the quarter + (1 - cos of the difference of "
              "headings) [m2].",
          .parameters = {ObjectParameter("object", "What is set down."), ObjectParameter("host", "What carries it."),
                         CornerParameter("corner", "Which corner.", Corner::kBackLeft)},
          .sentences = {{"A lamp stands on the back left corner of the desk.", "object=lamp host=desk"},
                        {"A plant is on the right front corner of the sideboard.",
                         "object=plant host=sideboard corner=front_right"}},
          .layouts = {Satisfied("5x4 room; desk 1.2x0.6 at 2,2,0; lamp 0.2x0.2 at 1.6,1.85,0 surface on desk",
                                "object=lamp host=desk"),
                      Violated("5x4 room; desk 1.2x0.6 at 2,2,0; lamp 0.2x0.2 at 2.3,1.85,5 surface on desk",
                               "object=lamp host=desk"),
                      Violated("5x4 room; desk 1.2x0.6 at 2,2,0; lamp 0.2x0.2 at 1.35,1.85,5 surface on desk",
                               "object=lamp host=desk")},
          .shortfall = OnTopCornerShortfall,
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            const int object = a.Object("object");
            const int host = a.Object("host");
            const Footprint& small = FootprintOf(context, object);
            const Footprint& large = FootprintOf(context, host);
            const bool fits = small.width_m <= large.width_m && small.depth_m <= large.depth_m;
            return MakeCost(OnTopCorner{small, large, SignsOf(a.OneCorner("corner")), fits}, {object, host});
          }};
}

}  // namespace flair::optimizer
