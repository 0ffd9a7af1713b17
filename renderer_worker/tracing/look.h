// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "renderer_worker/scene/room_shape.h"
#include "renderer_worker/tracing/frame.h"
#include "renderer_worker/tracing/lights.h"

namespace flair::renderer {

// What is around the room, for the camera.
struct Surroundings {
  bool open = false;  // a model on a table: the ground catches its shadow
  float ground_z = -kSlabThickness_m;
  const RoomShape* room = nullptr;     // of an eye outside its walls: what is before them is not seen
  Vec3 backdrop{0.80F, 0.79F, 0.77F};  // where the eye meets nothing, as it shall appear
};

// Looks from `eye` in `direction` (unit). `pixel_rad` is the angle of a pixel, which patterns are filtered by.
Seen LookFrom(const World& world, const Lights& lights, const Surroundings& surroundings, Vec3 eye, Vec3 direction,
              float pixel_rad);
// The same in up to kMostRaysTogether neighbouring directions.
void LookFrom(const World& world, const Lights& lights, const Surroundings& surroundings, Vec3 eye,
              std::span<const Vec3> directions, float pixel_rad, std::span<Seen> seen);

// Whether it sends back images rather than gloss.
inline bool IsMirror(const Material& material) { return material.metallic > 0.7F && material.roughness < 0.16F; }

}  // namespace flair::renderer
