// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps an object out of the corners of the room.
//   cost = sum over corners K of max(min - max(|d_a|, |d_b|), 0)^2                                          [m2]
//   d_a, d_b  least signed distance of the object's corners to the lines of the two walls that meet at K
// Zero exactly when at every corner the object is at least min_distance_m from one of the two walls: it may stand
// against a wall, but not where two meet. Only corners that open inwards count. Kinks where the other wall is the
// farther one and where another of the object's corners is the nearest. Models call it (ind_not_in_corner); the
// released library has no such function.
#include <fmt/format.h>

#include <utility>
#include <vector>

#include "optimizer_worker/autodiff/smooth.h"
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/footprint.h"
#include "room/scene/room.h"

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

struct NotInCorner {
  static constexpr int kObjects = 1;
  Footprint footprint;
  double min_distance_m;
  // The walls before and after each corner.
  std::vector<std::pair<Wall, Wall>> corners;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const {
    const auto points = Corners(footprint, frames[0]);
    T sum(0.0);
    for (const auto& [before, after] : corners) {
      const T a = Distance<T>(points, before), b = Distance<T>(points, after);
      sum += SquaredHinge(min_distance_m - (ValueOf(a) > ValueOf(b) ? a : b));
    }
    return sum;
  }
};

std::optional<Shortfall> NotInCornerShortfall(const PlacedCall& call) {
  const double into = call.CostRoot();
  return Worst({{fmt::format("{} stands {:.2f} m too far into a corner", call.NameOf("object"), into), into, "m"}});
}

}  // namespace

ConstraintFacts NotInCornerFacts() {
  return {
      .name = "not_in_corner",
      .aliases = {"ind_not_in_corner", "io_not_in_corner"},
      .family = "wall",
      .summary = "`object` stands in no corner: at least `min_distance_m` from one of the two walls that meet there.",
      .phrase = "stays out of the corners",
      .doc = "cost = sum over corners of max(min_distance_m - the larger of the distances to its two walls, 0)^2 [m2].",
      .parameters = {ObjectParameter("object", "What stays out of the corners."),
                     LengthParameter("min_distance_m", "Smallest distance to one wall of every corner.", 0, 20, 0.35)},
      .sentences = {{"The plunge pool is not in a corner.", "object=pool"}},
      .layouts = {Satisfied("4x3 room; pool 1x1 at 2,0.5,0", "object=pool"),
                  Satisfied("4x3 room; pool 1x1 at 0.9,0.5,0", "object=pool"),
                  Violated("4x3 room; pool 1x1 at 0.6,0.5,0", "object=pool"),
                  Violated("4x3 room; pool 1x0.6 at 3.5,2.6,90", "object=pool min_distance_m=0.5"),
                  Satisfied("room 0,0 4,0 4,2 2,2 2,4 0,4; pool 1x0.5 at 2.6,1.7,0", "object=pool")},
      .shortfall = NotInCornerShortfall,
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        const int object = a.Object("object");
        return MakeCost(
            NotInCorner{FootprintOf(context, object), a.Number("min_distance_m"), CornerWalls(context.scene.room)},
            {object});
      }};
}

}  // namespace flair::optimizer
