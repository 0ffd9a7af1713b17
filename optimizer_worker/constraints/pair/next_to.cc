// SPDX-License-Identifier: GPL-3.0-or-later
// Puts a side of one object next to a side of another.
//   cost = min over allowed pairs of sides of  gap^2 + overhang^2 + (1 + n1 . n2)                  [m2]
//   gap       distance of the object's side's middle along the target side's outward normal, beyond [0, kSlack]
//   overhang  how far the shorter side sticks out beyond the longer, max(|along| - |L1 - L2| / 2, 0)
//   n1, n2    outward normals of the two sides; opposed when the sides meet
// Zero exactly when the sides meet (up to 5 cm of air), parallel, the shorter within the longer. Sides left out may be
// any. The released io_next_to mixes metres and fractions and is right only for sides of 1 m (SEMANTICS.md section 4).
#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "optimizer_worker/constraints/measure/walls.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

namespace {

// Air that still counts as next to.
inline constexpr double kNextToSlack_m = 0.05;

// The cost of one pair of sides, shared with groups.
template <typename T>
T SidesMeet(const Footprint& first, const Frame<T>& first_frame, Side first_side, const Footprint& second,
            const Frame<T>& second_frame, Side second_side);

template <typename T>
T SidesMeet(const Footprint& first, const Frame<T>& first_frame, Side first_side, const Footprint& second,
            const Frame<T>& second_frame, Side second_side) {
  const Vec2<T> n1 = NormalOf(first_frame, first_side);
  const Vec2<T> n2 = NormalOf(second_frame, second_side);
  const Vec2<T> between = MiddleOf(first, first_frame, first_side) - MiddleOf(second, second_frame, second_side);
  const double play = std::abs(SideLength(first, first_side) - SideLength(second, second_side)) / 2;
  return SquaredOutside(Dot(between, n2), 0, kNextToSlack_m) + SquaredOutside(Cross(n2, between), -play, play) +
         (T(1.0) + Dot(n1, n2));
}

struct NextTo {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;
  static constexpr bool kSeesZero = true;
  Footprint object;
  Footprint target;
  // Side of the object, side of the target.
  std::vector<std::pair<Side, Side>> ways;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const {
    return LeastOf<T>(ways, frames, [this](const std::pair<Side, Side>& way, const auto& f) {
      return SidesMeet(object, f[0], way.first, target, f[1], way.second);
    });
  }
};

std::vector<Side> SidesOrAll(const std::optional<Side>& side) {
  if (side.has_value()) return {*side};
  return {kSides.begin(), kSides.end()};
}

absl::StatusOr<std::unique_ptr<Cost>> BindNextTo(const Arguments& a, const BindContext& context) {
  const int object = a.Object("object");
  const int target = a.Object("target");
  NextTo formula{FootprintOf(context, object), FootprintOf(context, target), {}};
  for (Side first : SidesOrAll(a.MaybeSide("object_side"))) {
    for (Side second : SidesOrAll(a.MaybeSide("target_side"))) formula.ways.emplace_back(first, second);
  }
  return MakeCost(std::move(formula), {object, target});
}

std::optional<Shortfall> NextToShortfall(const PlacedCall& call) {
  const int object = call.object(), target = call.target();
  const double gap = call.GapBetween(object, target);
  constexpr double kTouching_m = 0.05;
  if (const std::optional<Shortfall> far = Worst({TooFar(call.Name(object), call.Name(target), gap, kTouching_m)}))
    return far;
  return Worst({OffBy(call.Name(object), fmt::format("its place beside {}", call.Name(target)), call.CostRoot())});
}

}  // namespace

ConstraintFacts NextToFacts() {
  return {
      .name = "next_to",
      .aliases = {"io_next_to", "p_next_to", "ind_next_to"},
      .family = "pair",
      .summary =
          "A side of `object` touches a side of `target` (up to 5 cm of air), the shorter side within the longer.",
      .phrase = "stands right beside {target}",
      .doc =
          "cost = min over allowed pairs of sides of gap^2 + overhang^2 + (1 - cos angle) [m2]: gap beyond [0, 0.05 m] "
          "along the target side's normal, overhang of the shorter side beyond the longer, angle to facing sides. "
          "The released function compares metres with fractions and is right only for sides of 1 m.",
      .parameters = {ObjectParameter("object", "What is put there."), ObjectParameter("target", "What it stands at."),
                     OptionalSide("object_side", "Its side that touches; any when left out."),
                     OptionalSide("target_side", "The target's side that is touched; any when left out.")},
      .sentences = {{"The nightstand is next to the bed.", "object=nightstand target=bed"},
                    {"The left nightstand is on the left side of the bed.",
                     "object=nightstand target=bed target_side=left"},
                    {"The chair is pushed up to the front of the desk.",
                     "object=chair target=desk object_side=front target_side=front"}},
      .layouts = {Satisfied("5x4 room; stand 0.5x0.4 at 1.25,2.3,0; bed 1.5x2 at 2.25,2,0", "object=stand target=bed"),
                  Satisfied("5x4 room; chair 0.5x0.5 at 2.3,1.92,180; desk 1.2x0.6 at 2,1.35,0",
                            "object=chair target=desk object_side=front target_side=front"),
                  Violated("5x4 room; stand 0.5x0.4 at 0.8,2.3,0; bed 1.5x2 at 2.25,2,0", "object=stand target=bed"),
                  Violated("5x4 room; stand 0.5x0.4 at 1.25,3.3,0; bed 1.5x2 at 2.25,2,10", "object=stand target=bed"),
                  Violated("5x4 room; stand 0.5x0.4 at 1.25,2.3,0; bed 1.5x2 at 2.25,2,0",
                           "object=stand target=bed target_side=right")},
      .shortfall = NextToShortfall,
      .bind = BindNextTo};
}

}  // namespace flair::optimizer
