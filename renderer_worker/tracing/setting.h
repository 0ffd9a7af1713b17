// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "renderer_worker/tracing/frame.h"
#include "renderer_worker/tracing/lights.h"
#include "renderer_worker/tracing/look.h"
#include "renderer_worker/tracing/radiosity.h"
#include "renderer_worker/tracing/world.h"

namespace flair::renderer {

// All that a picture is taken of, and from where.
struct Setting {
  const World& world;
  const Lights& lights;
  const Radiosity& radiosity;
  const Surroundings& surroundings;
  const PinholeCamera& camera;
  float pixel_rad() const { return 1 / camera.focal_px; }
};

}  // namespace flair::renderer
