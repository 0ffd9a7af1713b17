// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "absl/container/flat_hash_map.h"
#include "absl/status/statusor.h"
#include "renderer_worker/scene/room_shape.h"
#include "renderer_worker/tracing/lights.h"
#include "renderer_worker/tracing/world.h"
#include "worker_runtime/executor/parallel.h"

namespace flair::renderer {

// A point a little off a surface, on its front.
struct SurfacePoint {
  Vec3 position;
  Vec3 normal;
  int instance = 0;
};

// Points spread evenly over everything that holds up light: about `count` by area, at least three an instance.
std::vector<SurfacePoint> SpreadPoints(const World& world, int count);

// Whether something keeps a sample of a light from a point.
inline bool IsShaded(const World& world, Vec3 position, const LightSample& from) {
  // Windows and balls are no surfaces: just short of them is far enough.
  return world.Shaded(position, from.direction, from.distance * 0.999F);
}

// What the lights send to a point straight away: one sample of the lamps and windows, one of the sun.
Vec3 DirectLight(const World& world, const LightChoice& choice, Vec3 position, const PixelSamples& random, int sample);

// Mean over points and samples of what the lights send to a point directly, over pi.
float MeanDirectLight(const World& world, const Lights& lights, const std::vector<SurfacePoint>& points, int samples);

// Brings daylight, lamps and fill of a room with a ceiling into proportion: the daylight falls with a mean of about
// 0.6; a room that gets next to none has a soft fill below its ceiling instead.
void BalanceLights(const World& world, const std::vector<SurfacePoint>& points, const RoomShape& shape, Lights& lights);

// The light that falls on every surface of a room, coarsely: points all over the surfaces gather light from the lights
// and from each other (the same rays for every bounce), and are averaged by instance, cell and side. It is what the
// fine picture sees where it looks at another surface (final gathering). Irradiance is over pi: what a white diffuse
// surface sends back as radiance. Thread-safe once made.
class Radiosity {
 public:
  // What the workers' check_alive says when it is not well.
  static absl::StatusOr<std::unique_ptr<Radiosity>> Solve(const World& world, const Lights& lights,
                                                          const std::vector<SurfacePoint>& points,
                                                          const runtime::Workers& workers);

  // What falls on the surface of `instance` about `position` on the side of `normal`.
  Vec3 IrradianceAt(int instance, Vec3 position, Vec3 normal) const;

 private:
  uint64_t KeyOf(int instance, Vec3 position, int side) const;
  int CellAt(int instance, Vec3 position, Vec3 normal) const;
  std::vector<int> AssignCells(const std::vector<SurfacePoint>& points, size_t instance_count);
  void Average(const std::vector<SurfacePoint>& points, const std::vector<int>& cell_of,
               const std::vector<Vec3>& values);

  float cells_per_m_ = 1 / 0.35F;
  absl::flat_hash_map<uint64_t, int> cells_;
  int first_fallback_ = 0;        // six sides of each instance, for where there is no cell
  std::vector<Vec3> irradiance_;  // by cell, then by fallback
};

}  // namespace flair::renderer
