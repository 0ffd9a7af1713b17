// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/wall/parallel_to_wall.h"

#include <algorithm>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/measure/choose.h"

namespace flair::optimizer {

template <typename T>
T ParallelToWall::operator()(const Frames<T, 1>& frames) const {
  // sin(2 a) / 2 = sin(a) cos(a), a the angle between front and wall.
  return LeastOf<T>(directions, frames, [](const Vec2<double>& direction, const auto& f) {
    const auto along = Cast<std::decay_t<decltype(f[0].front.x)>>(direction);
    return Square(Cross(along, f[0].front) * Dot(along, f[0].front));
  });
}

namespace {

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

}  // namespace

ConstraintFacts ParallelToWallFacts() {
  return {.name = "parallel_to_wall",
          .aliases = {"ind_parallel_to_wall", "io_parallel_to_wall"},
          .family = "wall",
          .summary = "The sides of `object` run along a wall, at any distance.",
          .doc = "cost = min over walls of sin^2(2 angle) / 4 [rad2], angle between the object's front and the wall.",
          .parameters = {ObjectParameter("object", "What is turned.")},
          .sentences = {{"The dining table is parallel to a wall.", "object=table"}},
          .layouts = {Satisfied("4x3 room; table 1x0.8 at 2,1.5,90", "object=table"),
                      Satisfied("4x3 room; table 1x0.8 at 2,1.5,180", "object=table"),
                      Violated("4x3 room; table 1x0.8 at 2,1.5,20", "object=table"),
                      Satisfied("room 0,0 4,0 4,2 2,4 0,4; table 1x0.8 at 2,1.5,45", "object=table"),
                      Violated("room 0,0 4,0 4,2 2,4 0,4; table 1x0.8 at 2,1.5,20", "object=table")},
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            return MakeCost(ParallelToWall{DirectionsOf(context.scene.room)}, {a.Object("object")});
          }};
}

}  // namespace flair::optimizer
