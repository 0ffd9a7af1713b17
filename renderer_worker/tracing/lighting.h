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

// Light for pixel (column, row): `round_count` times a path to a lamp or window and one to the sun, as often one to
// another surface (half as often within a room), and a quarter as often a mirrored one where the surface shines.
Lit LightOf(const World& world, const Lights& lights, const Radiosity& radiosity, const Seen& seen,
            const SampleSeeds& seeds, int column, int row, int round_count);

}  // namespace flair::renderer
