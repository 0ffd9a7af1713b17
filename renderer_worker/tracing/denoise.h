// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "absl/status/status.h"
#include "renderer_worker/tracing/frame.h"
#include "renderer_worker/tracing/lighting.h"

namespace flair::renderer {

// Smooths the light of a picture, not its surfaces: an edge-stopping a-trous wavelet (Dammertz et al. 2010), steered by
// instance, normal, plane and, as in SVGF (Schied et al. 2017), by how much of a difference noise accounts for. `seen`
// and `lit` are planes of the picture.
absl::Status SmoothLight(int width_px, int height_px, float pixel_rad, std::span<const Seen> seen,
                         const Workers& workers, std::span<Lit> lit);

}  // namespace flair::renderer
