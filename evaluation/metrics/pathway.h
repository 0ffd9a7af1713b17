// SPDX-License-Identifier: GPL-3.0-or-later
// [Paper] pathway cost: how much furniture stands on the ways through the room.
//   cost = sum over pieces of ways  length * sum_{k=-3..3} w_k depth(p + 0.1 k n)^2        [m3],  w = 1 2 3 4 3 2 1
//   p, n   middle of the piece and the direction across it;  ways: see FindWays
//   depth  distance of a point inside a solid floor object to its outline; 0 outside
// 0 when nothing stands within 0.3 m of a way. The released function sums over samples instead of length, which makes
// it jump when something moves by a millimetre, pays for rugs, and needs exactly one door (SEMANTICS.md section 7).
#pragma once

#include <vector>

#include "evaluation/metrics/layout_metrics.h"
#include "room/geometry/vec2.h"

namespace flair::evaluation {

double PathwayCost_m3(const LayoutView& view);

// The ways through a furnished room: the medial axis of the free floor, from Voronoi ridges of samples on its boundary.
// [Paper] pathway cost, where the ridges of the same kind of diagram are the ways.
//   boundary  walls without their door openings, and the outlines of solid floor objects (rugs are walked over)
//   way       points with the same distance to two places of the boundary that lie on opposite sides of them
// A ridge counts by how opposite its two places are: not at all when they are seen at 104 degrees or less (the branch
// into a corner of the room is no way), fully from 143. A slit narrower than 0.02 m is no way: things touch; one of
// 0.04 m counts fully. Both rise linearly in between, so that the result changes steadily as objects move.

// A short piece of a way.
struct WayPiece {
  Vec2<double> middle;
  // Unit vector across the way, towards one of the two places.
  Vec2<double> across;
  // Length times how much it counts.
  double weighted_length_m = 0;
  // Distance to the boundary: half the way's width.
  double half_width_m = 0;
};

// Pieces of at most 0.05 m on the floor and outside of objects. Deterministic; exact to the samples' spacing of 0.018
// m.
std::vector<WayPiece> FindWays(const LayoutView& view);

}  // namespace flair::evaluation
