// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace flair::renderer {

// How high things lie that are put on a piece of furniture of our making, metres above its underside: on the mattress
// of a bed, the seat of a sofa, the top of a dressing table below its mirror. The piece's height, (0, inf), for all
// others.
float RestHeightOf(std::string_view class_name, float height_m);

}  // namespace flair::renderer
