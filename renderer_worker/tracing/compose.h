// SPDX-License-Identifier: GPL-3.0-or-later
// How the colour of a picture comes about: light is smoothed, and put together with what is seen.
#pragma once

#include "absl/status/status.h"
#include "renderer_worker/tracing/frame.h"
#include "renderer_worker/tracing/lighting.h"
#include "renderer_worker/tracing/sampling.h"
#include "renderer_worker/tracing/trace_view.h"
#include "worker_runtime/executor/parallel.h"

namespace flair::renderer {

// `scratch` is memory for kLightCount planes like those of the grid.

// Points that are much brighter than all their neighbours of one instance, but for one, share their light with them:
// few samples found what all others missed, and smoothing would take it for something real. No light is lost.
absl::Status SpreadSparks(const runtime::Workers& workers, LightGrid& grid, Planes& scratch);

// Smooths the light of a grid, not its surfaces: an edge-stopping a-trous wavelet (Dammertz et al. 2010) in
// `round_count` rounds, steered by instance, normal, plane and, as in SVGF (Schied et al. 2017), by how much of a
// difference noise accounts for.
absl::Status SmoothLight(const runtime::Workers& workers, int round_count, LightGrid& grid, Planes& scratch);

// Smooths what the surfaces at the points of `grid` mirror; only their edges stop it.
absl::Status SmoothGloss(const runtime::Workers& workers, int round_count, const LightGrid& grid, Planes& gloss);

// Fills the colour of a view whose other planes are there: light times surfaces, edges looked at several times, exposed
// by how much light falls on what is seen.
absl::Status ComposeColour(const Setting& setting, const SampleSeeds& seeds, const Frame& frame,
                           const runtime::Workers& workers, TracedView& view);

}  // namespace flair::renderer
