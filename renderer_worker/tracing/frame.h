// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "flair/v1/view_annotations.pb.h"
#include "renderer_worker/scene/scene.h"
#include "renderer_worker/tracing/parallel.h"
#include "renderer_worker/tracing/world.h"

namespace flair::renderer {

// A pinhole camera with its picture: x right, y down, z forward, as v1::CameraParameters.
struct PinholeCamera {
  int width_px = 0, height_px = 0;
  float focal_px = 1;
  Vec3 eye, right, down, forward;

  // INVALID_ARGUMENT for a camera that looks straight up or down, or whose numbers are none.
  static absl::StatusOr<PinholeCamera> Make(const SceneCamera& camera, int width_px, int height_px);
  // Unit direction through a point of the picture; pixel (0, 0) covers [0, 1) x [0, 1).
  Vec3 Through(float column, float row) const {
    const float x = (column - 0.5F * static_cast<float>(width_px)) / focal_px;
    const float y = (row - 0.5F * static_cast<float>(height_px)) / focal_px;
    return Normalized(forward + right * x + down * y);
  }
  v1::CameraParameters Parameters() const;
};

// What is seen in a direction: the first surface, and, where that is glass or a mirror, the one whose light comes
// through or back.
struct Seen {
  int instance = -1;   // of the first surface; index in World::instances, -1 for nothing
  float distance = 0;  // to it
  Vec3 first_normal;
  Vec3 first_albedo;
  // What is lit: the surface behind glass or in mirrors.
  int lit_instance = -1;
  Vec3 position, normal;
  Vec3 albedo;    // diffuse, filtered
  Vec3 specular;  // reflectance straight on
  float roughness = 1;
  Vec3 filter{1, 1, 1};  // what glass and mirrors on the way leave of its light
  Vec3 added;            // light that comes from the way itself: emission, the sky behind
  Vec3 direction;        // in which the lit surface was looked at
  bool background = false;
};

}  // namespace flair::renderer
