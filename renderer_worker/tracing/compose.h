// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/status.h"
#include "renderer_worker/tracing/lighting.h"
#include "renderer_worker/tracing/sampling.h"
#include "renderer_worker/tracing/trace_view.h"
#include "worker_runtime/executor/parallel.h"

namespace flair::renderer {

// Fills the colour of a view whose other planes are there: light times surfaces, edges looked at several times, exposed
// by how much light falls on what is seen.
absl::Status ComposeColour(const Setting& setting, const SampleSeeds& seeds, const Frame& frame,
                           const runtime::Workers& workers, TracedView& view);

}  // namespace flair::renderer
