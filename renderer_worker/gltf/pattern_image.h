// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "renderer_worker/scene/material.h"

namespace flair::renderer::gltf {

// One period of a material's pattern as a PNG that tiles, row 0 at v = 0. Its pixels are numbers of tones, which depend
// on the pattern alone and are computed once per process; the palette gives them the material's colours. Empty for
// kPlain. Thread-safe, the same bytes for the same material.
std::string PatternPng(const Material& material);

}  // namespace flair::renderer::gltf
