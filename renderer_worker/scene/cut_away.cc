// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/scene/cut_away.h"

#include <algorithm>
#include <cmath>

namespace flair::renderer {
namespace {

// Points all over the floor, a little off the walls.
std::vector<Vec3> FloorSamples(const RoomShape& shape) {
  constexpr int kPerSide = 24;
  Vec2 low = shape.floor[0], high = shape.floor[0];
  for (const Vec2& p : shape.floor) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  std::vector<Vec3> samples;
  for (int i = 0; i < kPerSide; ++i) {
    for (int k = 0; k < kPerSide; ++k) {
      const float x = low.x + (high.x - low.x) * (static_cast<float>(i) + 0.5F) / kPerSide;
      const float y = low.y + (high.y - low.y) * (static_cast<float>(k) + 0.5F) / kPerSide;
      if (Inside(shape, x, y)) samples.push_back({x, y, 0});
    }
  }
  return samples;
}

// Whether the wall, up to the ceiling, stands between the eye and the point.
bool Hides(const ShapedWall& wall, float height_m, Vec3 eye, Vec3 point) {
  const float from = Dot(eye - wall.axes.origin, wall.axes.outward),
              to = Dot(point - wall.axes.origin, wall.axes.outward);
  if ((from > 0) == (to > 0) || std::abs(from - to) < 1e-6F) return false;
  const Vec3 at = eye + (point - eye) * (from / (from - to));
  const float along = Dot(at - wall.axes.origin, wall.axes.along);
  return along > 0 && along < wall.length_m && at.z < height_m;
}

}  // namespace

CutAway CutAwayFor(const RoomShape& shape, Vec3 eye) {
  CutAway cut;
  cut.ceiling = eye.z >= shape.height_m;
  cut.walls.assign(shape.walls.size(), WallCut::kWhole);
  if (!cut.ceiling && Inside(shape, eye.x, eye.y)) return cut;
  const std::vector<Vec3> samples = cut.ceiling ? FloorSamples(shape) : std::vector<Vec3>();
  for (size_t i = 0; i < shape.walls.size(); ++i) {
    const ShapedWall& wall = shape.walls[i];
    if (!cut.ceiling) {
      if (Dot(eye - wall.axes.origin, wall.axes.outward) > 0) cut.walls[i] = WallCut::kGone;
      continue;
    }
    const auto hidden =
        std::count_if(samples.begin(), samples.end(), [&](Vec3 p) { return Hides(wall, shape.height_m, eye, p); });
    if (hidden * 200 > static_cast<int64_t>(samples.size())) cut.walls[i] = WallCut::kStub;
  }
  return cut;
}

}  // namespace flair::renderer
