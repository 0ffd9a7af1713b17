// SPDX-License-Identifier: GPL-3.0-or-later
// What cannot be so in a real room, in three dimensions. Every piece is an upright prism: its footprint, from its
// underside to its top; of a surface piece the underside is the top of what carries it. Touching to 0.1 mm, and 1 cm in
// height, is no overlap.
//   overlap   two pieces in the same place, whatever carries them. Not counted: rugs and mats; a piece and what carries
//             it, on its top or within it (books in a bookshelf), directly or through others; on one top, things of up
//             to 5 cm, on which others stand; and knee space: of a floor piece that looks at another whose top is 0.6
//             to 1.2 m high, the front 0.3 m, as a chair's seat under a table
//   leaf      a piece, rugs apart, within what a door's leaf sweeps, up to the door's head
//   opening   a wall piece before a door or window, at its height; its depth along the wall counts
//   outside   a piece beyond the floor, or above the ceiling
//   support   a wall piece's back lies on one wall to 1 cm; a floor piece is on the floor; a surface piece stands on
//             something, reaches at most 1 cm over its edges (things of up to 5 cm hang over, but their middle lies on
//             it), and stands beside the opening of a top such as a basin's, or lies across it from rim to rim
//   headroom  a ceiling piece lower than 1.9 m hangs over furniture
#pragma once

#include <vector>

#include "evaluation/metrics/layout_metrics.h"
#include "flair/v1/layout_metrics.pb.h"

namespace flair::evaluation {

struct SolidMeasures {
  // Volumes outside the room and in the same place as something else, counted once a pair.
  double outside_m3 = 0;
  double overlap_m3 = 0;
  // The shortest push, in any direction, that ends the deepest overlap.
  double deepest_m = 0;
  int unsupported_count = 0;
  // Of each kind the worst first.
  std::vector<v1::Finding> findings;
};

SolidMeasures MeasureSolids(const LayoutView& view);

}  // namespace flair::evaluation
