// SPDX-License-Identifier: GPL-3.0-or-later
// Turns an object so that its sides run along a wall.
//   cost = min over walls of sin^2(2 (theta - phi)) / 4                                                    [rad2]
//   theta  heading of the object;  phi  direction of the wall
// Zero exactly when two sides of the object are parallel to a wall, near that the square of the angle that lacks. Kinks
// half way between the directions of two walls; a rectangle has one direction. Models call it (ind_parallel_to_wall);
// the released library has no such function, only `aligned` for all objects.
#include <algorithm>
#include <cmath>
#include <vector>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/choose.h"

namespace flair::optimizer {

namespace {

struct ParallelToWall {
  static constexpr int kObjects = 1;
  // Unit vectors along the walls, one of those that are parallel or at right angles.
  std::vector<Vec2<double>> directions;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const {
    // sin(2 a) / 2 = sin(a) cos(a), a the angle between front and wall.
    return LeastOf<T>(directions, frames, [](const Vec2<double>& direction, const auto& f) {
      const auto along = Cast<std::decay_t<decltype(f[0].front.x)>>(direction);
      return Square(Cross(along, f[0].front) * Dot(along, f[0].front));
    });
  }
};

std::vector<Vec2<double>> DirectionsOf(const Room& room) {
  std::vector<Vec2<double>> directions;
  for (const Wall& wall : room.walls) {
    const bool known = std::any_of(directions.begin(), directions.end(), [&](const Vec2<double>& other) {
      return std::abs(Cross(other, wall.Along()) * Dot(other, wall.Along())) < 1e-12;
    });
    if (!known) directions.push_back(wall.Along());
  }
  return directions;
}

std::optional<Shortfall> ParallelToWallShortfall(const PlacedCall& call) {
  const double angle_rad = std::asin(std::min(1.0, 2 * call.CostRoot())) / 2;
  return Worst({Turned(call.NameOf("object"), "the direction of the nearest wall", angle_rad)});
}

}  // namespace

ConstraintFacts ParallelToWallFacts() {
  return {.name = "parallel_to_wall",
          .aliases = {"ind_parallel_to_wall", "io_parallel_to_wall"},
          .family = "wall",
          .summary = "The sides of `object` run along a wall, at any distance.",
          .phrase = "stands parallel to the walls",
          .doc = "cost = min over walls of sin^2(2 angle) / 4 [rad2], angle between the object's front and the wall.",
          .parameters = {ObjectParameter("object", "What is turned.")},
          .sentences = {{"The dining table is parallel to a wall.", "object=table"}},
          .layouts = {Satisfied("4x3 room; table 1x0.8 at 2,1.5,90", "object=table"),
                      Satisfied("4x3 room; table 1x0.8 at 2,1.5,180", "object=table"),
                      Violated("4x3 room; table 1x0.8 at 2,1.5,20", "object=table"),
                      Satisfied("room 0,0 4,0 4,2 2,4 0,4; table 1x0.8 at 2,1.5,45", "object=table"),
                      Violated("room 0,0 4,0 4,2 2,4 0,4; table 1x0.8 at 2,1.5,20", "object=table")},
          .shortfall = ParallelToWallShortfall,
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            return MakeCost(ParallelToWall{DirectionsOf(context.scene.room)}, {a.Object("object")});
          }};
}

}  // namespace flair::optimizer
