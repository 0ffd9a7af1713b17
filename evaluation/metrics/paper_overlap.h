// SPDX-License-Identifier: GPL-3.0-or-later
// [Paper] OOR as the released code has it, to compare with published figures. overlap.h is the measure with its rules
// put right; for floor objects the two differ in two places only:
//   rugs   floor objects like others here: they overlap everything that stands on them
//   doors  a square here, whatever way the door opens: the leaf's width and 0.2 m more at both ends, into the room, and
//          behind the wall, except behind a wall that the room lies south of; the sector that the leaf sweeps there
#pragma once

#include "evaluation/metrics/layout_view.h"

namespace flair::evaluation {

// Floor objects against each other and in door zones, percent of the room's area. Without tertiary objects, which the
// released measure cannot take when their type was not recorded.
double OorPaperPercent(const LayoutView& view);

}  // namespace flair::evaluation
