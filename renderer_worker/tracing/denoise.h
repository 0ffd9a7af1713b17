// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/status.h"
#include "renderer_worker/tracing/frame.h"
#include "renderer_worker/tracing/parallel.h"

namespace flair::renderer {

// Points that are more than `most` times as bright as all their neighbours of one instance come down to the brightest
// of them: few samples found something that all others missed.
absl::Status TameSparks(const Workers& workers, float most, LightGrid& grid);

// Smooths the light of a grid, not its surfaces: an edge-stopping a-trous wavelet (Dammertz et al. 2010) in
// `round_count` rounds, steered by instance, normal, plane and, as in SVGF (Schied et al. 2017), by how much of a
// difference noise accounts for.
absl::Status SmoothLight(const Workers& workers, int round_count, LightGrid& grid);

// Smooths what the surfaces at the points of `grid` mirror; only their edges stop it.
absl::Status SmoothGloss(const Workers& workers, int round_count, const LightGrid& grid, Planes& gloss);

}  // namespace flair::renderer
