// SPDX-License-Identifier: GPL-3.0-or-later
// [Paper] pathway cost: how much furniture stands on the ways through the room.
//   cost = sum over pieces of ways  length * sum_{k=-3..3} w_k depth(p + 0.1 k n)^2        [m3],  w = 1 2 3 4 3 2 1
//   p, n   middle of the piece and the direction across it;  ways: see ways.h
//   depth  distance of a point inside a solid floor object to its outline; 0 outside
// 0 when nothing stands within 0.3 m of a way. The released function sums over samples instead of length, which makes
// it jump when something moves by a millimetre, pays for rugs, and needs exactly one door (SEMANTICS.md section 7).
#pragma once

#include "evaluation/metrics/layout_view.h"

namespace flair::evaluation {

double PathwayCost_m3(const LayoutView& view);

}  // namespace flair::evaluation
