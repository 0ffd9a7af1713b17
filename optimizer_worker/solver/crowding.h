// SPDX-License-Identifier: GPL-3.0-or-later
// How narrow the gaps are that furniture leaves: what the pathway cost of a layout will be, without its medial axis.
#pragma once

#include <span>

#include "optimizer_worker/solver/walk_grid.h"
#include "room/scene/room.h"

namespace flair::optimizer {

// Sum over pairs of obstacles, and obstacles and walls, of  length * F(gap)  [m3]
//   gap     between two sides that face each other in parallel, above 0.02 m (less is touching) and below 0.6 m
//   length  on which they face each other
//   F       [Paper] cross-section of the pathway cost in the middle of such a gap: sum_{k=1..3} w_k max(0.1 k - gap/2,
//   0)^2
//           for each side that is furniture, w = 3 2 1
// Pairs at other angles than multiples of 90 degrees do not count, and nothing that stands in between is seen.
double CrowdingCost_m3(const Room& room, std::span<const Obstacle> obstacles);

}  // namespace flair::optimizer
