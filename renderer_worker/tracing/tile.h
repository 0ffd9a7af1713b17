// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "renderer_worker/tracing/setting.h"
#include "renderer_worker/tracing/trace_view.h"

namespace flair::renderer {

inline constexpr int kTileHeight = 4;

// Looks at rows [row, row + kTileHeight) of the picture, as far as there are, gathers the light that falls on what they
// show, and fills their part of `frame` and of the view's planes but the colour. `row` is a multiple of kTileHeight.
void TraceRows(const Setting& setting, const SampleSeeds& seeds, int round_count, int row, Frame& frame,
               TracedView& view);

}  // namespace flair::renderer
