// SPDX-License-Identifier: GPL-3.0-or-later
// How deep things stand in each other, in lengths instead of areas: an overlap of no depth is none.
#pragma once

#include "evaluation/metrics/layout_view.h"

namespace flair::evaluation {

// The largest of: the shortest push that parts two solid floor objects, or one from the swing of a door; the distance
// of a corner of any object beyond the floor. Metres, 0 when all is clear.
double DeepestOverlap_m(const LayoutView& view);

}  // namespace flair::evaluation
