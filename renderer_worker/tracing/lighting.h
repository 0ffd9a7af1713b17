// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "renderer_worker/tracing/frame.h"
#include "renderer_worker/tracing/lights.h"
#include "renderer_worker/tracing/radiosity.h"

namespace flair::renderer {

// What falls on the surface that a pixel shows: over pi, so that times the albedo it is radiance.
struct Lit {
  Vec3 irradiance;
  float variance = 0;  // of the luminance of `irradiance`, as a mean of the samples
  Vec3 gloss;          // radiance that the surface mirrors, roughly
};

// Gathers `sample_count` samples of light for pixel (column, row).
Lit LightOf(const World& world, const Lights& lights, const Radiosity& radiosity, const Seen& seen,
            const SampleSeeds& seeds, int column, int row, int sample_count);

}  // namespace flair::renderer
