// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "renderer_worker/scene/scene.h"
#include "renderer_worker/tracing/sampling.h"
#include "renderer_worker/tracing/world.h"

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

}  // namespace flair::renderer
