// SPDX-License-Identifier: GPL-3.0-or-later
// Puts an object between two others.
//   cost = max(|lateral| - play, 0)^2 + max(-s_1, 0)^2 + max(-s_2, 0)^2                                        [m2]
//   lateral  distance of its centre from the line through the centres of the two;  play  a quarter of its shorter side
//   s_1, s_2 how far its centre is from either, along that line, less half its shorter side
// Zero exactly when its centre lies on the way from one to the other. The released io_between asks it to touch both,
// with all three facing the same way (SEMANTICS.md section 4).
#include <fmt/format.h>

#include <algorithm>

#include "optimizer_worker/autodiff/smooth.h"
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

namespace {

struct Between {
  static constexpr int kObjects = 3;
  static constexpr bool kOnlyRelative = true;
  Footprint footprint;

  template <typename T>
  T operator()(const Frames<T, 3>& frames) const {
    const Vec2<T> way = frames[2].center - frames[1].center;
    const Vec2<T> from_first = frames[0].center - frames[1].center;
    const T length = Length(way);
    const double shorter = std::min(footprint.width_m, footprint.depth_m);
    constexpr double kNoWay_m = 1e-4;
    // Two in one place: there is nothing between them; near them is nearest.
    if (ValueOf(length) < kNoWay_m) return SquaredNorm(from_first) + T(shorter * shorter / 4);
    const T along = Dot(from_first, way) / length;
    const T lateral = Cross(way, from_first) / length;
    return SquaredOutside(lateral, -shorter / 4, shorter / 4) + SquaredHinge(shorter / 2 - along) +
           SquaredHinge(along - length + shorter / 2);
  }
};

std::optional<Shortfall> BetweenShortfall(const PlacedCall& call) {
  return Worst(
      {OffBy(call.NameOf("object"), fmt::format("the way from {} to {}", call.NameOf("first"), call.NameOf("second")),
             call.CostRoot())});
}

}  // namespace

ConstraintFacts BetweenFacts() {
  return {
      .name = "between",
      .aliases = {"io_between", "p_between"},
      .family = "pair",
      .summary = "`object` stands between `first` and `second`, on the line from one to the other.",
      .phrase = "stands between {first} and {second}",
      .doc =
          "cost = squared offset of its centre from the line through their centres, beyond a quarter of its shorter "
          "side, "
          "+ squared excess beyond their centres [m2]. The released function asks it to touch both.",
      .parameters = {ObjectParameter("object", "What is between."), ObjectParameter("first", "The one neighbour."),
                     ObjectParameter("second", "The other neighbour.")},
      .sentences = {{"The side table is between the two armchairs.", "object=table first=chair_1 second=chair_2"}},
      .layouts = {Satisfied("6x4 room; t 0.5x0.5 at 2,1.05,0; a 1x1 at 1,1,0; b 1x1 at 3,1,0",
                            "object=t first=a second=b"),
                  Violated("6x4 room; t 0.5x0.5 at 2,2,0; a 1x1 at 1,1,0; b 1x1 at 3,1,0", "object=t first=a second=b"),
                  Violated("6x4 room; t 0.5x0.5 at 4,1.3,0; a 1x1 at 1,1,0; b 1x1 at 3,1,0",
                           "object=t first=a second=b")},
      .shortfall = BetweenShortfall,
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        const int object = a.Object("object");
        return MakeCost(Between{FootprintOf(context, object)}, {object, a.Object("first"), a.Object("second")});
      }};
}

}  // namespace flair::optimizer
