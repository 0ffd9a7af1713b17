// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "absl/container/flat_hash_map.h"
#include "absl/status/statusor.h"
#include "renderer_worker/scene/room_shape.h"
#include "renderer_worker/scene/scene.h"
#include "renderer_worker/tracing/sampling.h"
#include "renderer_worker/tracing/world.h"
#include "worker_runtime/executor/executor.h"

namespace flair::renderer {

// A rectangle that shines to one side: a window full of sky, or the soft fill below the ceiling of a room without.
struct RectLight {
  Vec3 corner, along, up;
  Vec3 normal;  // unit, the side it shines to
  float area_m2 = 0;
  bool window = false;  // its radiance is that of the sky behind it
  Vec3 radiance;        // of a rectangle that is no window
};

// A ball that shines in every direction.
struct BallLight {
  Vec3 centre;
  Vec3 intensity;  // radiance times square metres
  float radius_m = 0.05F;
  // Beside the open sky its light fades to none at this distance, which few points then need to ask for; 0: it never
  // does.
  float reach_m = 0;
  float LeftAt(float distance2) const {
    if (reach_m <= 0) return 1;
    const float near = 1 - distance2 / (reach_m * reach_m);
    return near > 0 ? near * near : 0;
  }
};

// Everything that sends light. Radiance is relative: the sky overhead is about 1.
struct Lights {
  bool open_sky = false;     // rays that meet nothing see the sky; otherwise only those through windows
  bool uniform_sky = false;  // the same from everywhere: for tests of the balance of light
  float sky_scale = 1;
  Vec3 beyond;                  // see Beyond
  Vec3 sun_direction{0, 0, 1};  // unit, towards it
  Vec3 sun_irradiance;          // 0: no sun
  float sun_radius = 0.03F;     // tangent of half its angle
  std::vector<RectLight> rects;
  std::vector<BallLight> balls;

  // What is seen of the sky and the ground outside in that direction.
  Vec3 SkyRadiance(Vec3 direction) const;
  // What a ray that meets nothing finds: the sky, or, where walls are taken away, a room as light as this one; nothing
  // in windows, which are lights.
  Vec3 Beyond(Vec3 from, Vec3 direction) const;
  // The window that a ray from within passes through, -1 for none. Windows count as larger by `spread` times the way.
  int WindowThrough(Vec3 from, Vec3 direction, float spread = 0) const;
};

// A light chosen for a point, and a way to it.
struct LightSample {
  Vec3 direction;
  float distance = 0;
  Vec3 irradiance;  // unshadowed, over pi, divided by the probability of the choice; 0 when nothing comes from there
};

// Chooses among the lights for one point of a surface, by how much each of them may give it. Borrows the lights.
class LightChoice {
 public:
  LightChoice(const Lights& lights, Vec3 position, Vec3 normal);
  // One sample of the light that comes straight from the lights but the sun. `choice` picks the light, `place` the
  // point on it.
  LightSample Sample(float choice, Vec2 place) const;
  // One sample of the sun's light.
  LightSample SampleSun(Vec2 place) const;
  bool sun() const { return sun_; }
  bool any() const { return total_ > 0; }

 private:
  static constexpr size_t kMost = 256;
  const Lights& lights_;
  Vec3 position_, normal_;
  bool sun_ = false;  // whether some of it may get here
  float total_ = 0;
  size_t count_ = 0;
  std::array<float, kMost> guess_;
};

// The lights of a scene: windows and lamps below a ceiling; sky, sun and faint lamps without one. Not yet balanced.
Lights LightsOf(const Scene& scene, bool open_sky);

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
