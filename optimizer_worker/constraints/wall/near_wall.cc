// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps one side of an object (its back by default) near a wall and turned to it.
//   cost = min over walls of  out(gap, [0, max])^2 + max(cos 45 - cos a, 0)^2 + out(offset, wall)^2        [m2]
//   gap     mean signed distance of the side's two ends to the wall's line
//   a       angle between the side's outward normal and the direction into the wall
//   offset  place of the side's middle along the wall
// Zero exactly when the side is at most max_distance_m from a wall that it looks at (within 45 degrees). The released
// ind_near_wall has no side, so that calls with one fail silently (SEMANTICS.md section 3).
#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "optimizer_worker/constraints/measure/walls.h"
#include "room/geometry/footprint.h"
#include "room/geometry/pose.h"
#include "room/scene/room.h"

namespace flair::optimizer {

namespace {

struct NearWall {
  static constexpr int kObjects = 1;
  static constexpr bool kSeesZero = true;
  Footprint footprint;
  Side side;
  double max_distance_m;
  std::vector<Wall> walls;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const {
    return LeastOf<T>(walls, frames, [this](const Wall& wall, const auto& f) {
      constexpr double kCos45 = 0.70710678118654757;
      const auto middle = MiddleOf(footprint, f[0], side);
      return SquaredOutside(wall.Height(middle), 0, max_distance_m) +
             SquaredHinge(TurnToWall(f[0], side, wall) - (1 - kCos45)) +
             SquaredOutside(wall.Offset(middle), 0, wall.length_m);
    });
  }
};

std::optional<Shortfall> NearWallShortfall(const PlacedCall& call) {
  const int object = call.object();
  const Side side = call.arguments().OneSide("side");
  const double most = call.arguments().Number("max_distance_m");
  const Frame<double> frame = call.FrameOf(object);
  const Vec2<double> middle = MiddleOf(call.FootprintOf(object), frame, side);
  const auto beyond_end = [&](const Wall& w) {
    return std::max({0.0, -w.Offset(middle), w.Offset(middle) - w.length_m});
  };
  const Wall& wall = call.BestWall([&](const Wall& w) {
    const double turn = TurnToWall(frame, side, w), height = w.Height(middle);
    const double off = std::max({0.0, height - most, -height});
    return off * off + std::max(0.0, turn - 1 + std::sqrt(0.5)) + beyond_end(w) * beyond_end(w);
  });
  const std::string what = SideOf(call.Name(object), side), place = WallName(wall);
  return Worst(
      {TooFar(what, place, wall.Height(middle), most),
       Turned(what, place, AngleOf(NormalOf(frame, side), -wall.inward_normal), kPi / 4),
       {fmt::format("{} is {:.2f} m beyond {}", what, -wall.Height(middle), place), -wall.Height(middle), "m"},
       {fmt::format("{} is {:.2f} m beyond the end of {}", what, beyond_end(wall), place), beyond_end(wall), "m"}});
}

}  // namespace

ConstraintFacts NearWallFacts() {
  return {.name = "near_wall",
          .aliases = {"ind_near_wall", "io_near_wall"},
          .family = "wall",
          .summary = "The given side of `object` (its back by default) is within `max_distance_m` of a wall.",
          .phrase = "has its {side} within {max_distance_m} of {wall|a wall}",
          .doc =
              "cost = min over walls of squared excess of the side's mean distance over max_distance_m, of its angle "
              "over 45 "
              "degrees and of its place beyond the wall's ends [m2]. The released function ignores the side.",
          .parameters = {ObjectParameter("object", "What is near a wall."),
                         SideParameter("side", "Its side that looks at the wall.", Side::kBack),
                         OptionalWall("wall", "The wall; any wall when left out."),
                         LengthParameter("max_distance_m", "Largest mean distance of the side.", 0, 20, 0.5)},
          .sentences = {{"The sofa is near a wall.", "object=sofa"},
                        {"The bookshelf is within 20 cm of the wall.", "object=bookshelf max_distance_m=0.2"}},
          .layouts = {Satisfied("4x3 room; sofa 2x0.9 at 2,0.9,10", "object=sofa"),
                      Violated("4x3 room; sofa 2x0.9 at 2,1.4,10", "object=sofa"),
                      Violated("4x3 room; sofa 2x0.9 at 2,0.45,0", "object=sofa side=front")},
          .shortfall = NearWallShortfall,
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            const int object = a.Object("object");
            return MakeCost(NearWall{FootprintOf(context, object), a.OneSide("side"), a.Number("max_distance_m"),
                                     WallsToUse(context.scene.room, a.MaybeWall("wall"))},
                            {object});
          }};
}

}  // namespace flair::optimizer
