// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace flair::renderer::gltf {

// To six decimals, so that files hold 0.8 and not 0.800000011920929. Zero is positive.
inline double Rounded(double value) { return std::round(value * 1e6) / 1e6 + 0.0; }

}  // namespace flair::renderer::gltf
