// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/wall/not_in_corner.h"

#include "optimizer_worker/autodiff/smooth.h"
#include "optimizer_worker/constraints/facts.h"

namespace flair::optimizer {
namespace {

// |least signed distance of the points to the wall's line|.
template <typename T, typename Points>
T Distance(const Points& points, const Wall& wall) {
  T least = wall.Height(points[0]);
  for (const Vec2<T>& point : points) {
    const T height = wall.Height(point);
    if (ValueOf(height) < ValueOf(least)) least = height;
  }
  return Magnitude(least);
}

std::vector<std::pair<Wall, Wall>> CornerWalls(const Room& room) {
  std::vector<std::pair<Wall, Wall>> corners;
  for (size_t i = 0; i < room.walls.size(); ++i) {
    const Wall& before = room.walls[i];
    const Wall& after = room.walls[(i + 1) % room.walls.size()];
    if (Cross(before.Along(), after.Along()) > 1e-6) corners.emplace_back(before, after);
  }
  return corners;
}

}  // namespace

template <typename T>
T NotInCorner::operator()(const Frames<T, 1>& frames) const {
  const auto points = Corners(footprint, frames[0]);
  T sum(0.0);
  for (const auto& [before, after] : corners) {
    const T a = Distance<T>(points, before), b = Distance<T>(points, after);
    sum += SquaredHinge(min_distance_m - (ValueOf(a) > ValueOf(b) ? a : b));
  }
  return sum;
}

ConstraintFacts NotInCornerFacts() {
  return {
      .name = "not_in_corner",
      .aliases = {"ind_not_in_corner", "io_not_in_corner"},
      .family = "wall",
      .summary = "`object` stands in no corner: at least `min_distance_m` from one of the two walls that meet there.",
      .doc = "cost = sum over corners of max(min_distance_m - the larger of the distances to its two walls, 0)^2 [m2].",
      .parameters = {ObjectParameter("object", "What stays out of the corners."),
                     LengthParameter("min_distance_m", "Smallest distance to one wall of every corner.", 0, 20, 0.35)},
      .sentences = {{"The plunge pool is not in a corner.", "object=pool"}},
      .layouts = {Satisfied("4x3 room; pool 1x1 at 2,0.5,0", "object=pool"),
                  Satisfied("4x3 room; pool 1x1 at 0.9,0.5,0", "object=pool"),
                  Violated("4x3 room; pool 1x1 at 0.6,0.5,0", "object=pool"),
                  Violated("4x3 room; pool 1x0.6 at 3.5,2.6,90", "object=pool min_distance_m=0.5"),
                  Satisfied("room 0,0 4,0 4,2 2,2 2,4 0,4; pool 1x0.5 at 2.6,1.7,0", "object=pool")},
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        const int object = a.Object("object");
        return MakeCost(
            NotInCorner{FootprintOf(context, object), a.Number("min_distance_m"), CornerWalls(context.scene.room)},
            {object});
      }};
}

}  // namespace flair::optimizer
