// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "renderer_worker/scene/cut_away.h"
#include "renderer_worker/scene/scene.h"
#include "renderer_worker/tracing/sampling.h"

namespace flair::renderer {

// A mesh where it stands: turned about z, then moved.
struct WorldInstance {
  int instance_id = 0;
  int class_id = 0;
  const Mesh* mesh = nullptr;
  int mesh_index = 0;
  float cosine = 1, sine = 0;
  Vec3 origin;
  bool seen = true;    // by the camera
  bool shades = true;  // holds up light
  Vec3 ToRoom(Vec3 p) const { return TurnToRoom(p) + origin; }
  Vec3 TurnToRoom(Vec3 v) const { return {v.x * cosine - v.y * sine, v.x * sine + v.y * cosine, v.z}; }
};

// The scene's objects, then the parts of its shell. Ids count all of them, seen or not: the same in every view.
std::vector<WorldInstance> InstancesOf(const Scene& scene, const CutAway& cut);

// Whether what is behind lies in shadow: neither glass nor a lamp.
inline bool HoldsUpLight(const Material& material) {
  return material.opacity >= 1 && Luminance(material.emission) <= 0;
}

// Ids of the parts of a room, beside those of furniture classes.
inline constexpr int kFloorClass = 1001, kCeilingClass = 1002, kWallClass = 1003, kDoorClass = 1004,
                     kWindowClass = 1005, kSkirtingClass = 1006;

}  // namespace flair::renderer
