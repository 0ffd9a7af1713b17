// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "renderer_worker/tracing/lighting.h"
#include "renderer_worker/tracing/setting.h"

namespace flair::renderer {

inline constexpr int kBlockSide = 4;

// A square of neighbouring pixels; null beyond the picture.
using PixelBlock = std::array<const Seen*, kBlockSide * kBlockSide>;
using BlockLight = std::array<LightMean, kBlockSide * kBlockSide>;

// What falls on the pixels of a block, whose first one is (column, row), straight from lamps, windows and the sun.
// `round_count` samples of the sun, half as many of the others, whose half shadows are wide; but only a quarter where
// those of all pixels of a surface agree whether light gets there.
BlockLight DirectLightOn(const Setting& setting, const SampleSeeds& seeds, const PixelBlock& block, int column, int row,
                         int round_count);

}  // namespace flair::renderer
