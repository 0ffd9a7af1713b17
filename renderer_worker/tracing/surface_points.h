// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "renderer_worker/scene/room_shape.h"
#include "renderer_worker/tracing/lights.h"
#include "renderer_worker/tracing/world.h"

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

}  // namespace flair::renderer
