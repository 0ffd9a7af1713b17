// SPDX-License-Identifier: GPL-3.0-or-later
// The measures of a layout beside those of layout_metrics.h and walk_grid.h: solids, uses, pathway cost.
#pragma once

#include <limits>
#include <vector>

#include "evaluation/metrics/layout_metrics.h"
#include "flair/v1/layout_graph.pb.h"
#include "flair/v1/layout_metrics.pb.h"
#include "flair/v1/solved_layout.pb.h"
#include "room/geometry/pose.h"

namespace flair::evaluation {

// What cannot be so in a real room, in three dimensions. Every piece is an upright prism: its footprint, from its
// underside to its top; of a surface piece the underside is the top of what carries it. Touching to 0.1 mm, and 1 cm in
// height, is no overlap.
//   overlap   two pieces in the same place, whatever carries them. Not counted: rugs and mats; a piece and what carries
//             it, on its top or within it (books in a bookshelf), directly or through others; on one top, things of up
//             to 5 cm, on which others stand; and knee space: of a seat that looks at a table or whatever else is sat
//             at, of a top 0.6 to 1.2 m high, the front 0.3 m; pieces of no known class may be seats and tables
//   leaf      a piece, rugs apart, within what a door's leaf sweeps, up to the door's head
//   opening   a wall piece before a door or window, at its height; its depth along the wall counts
//   outside   a piece beyond the floor, or above the ceiling
//   support   a wall piece's back lies on one wall to 1 cm; a floor piece is on the floor; a surface piece stands on
//             something, reaches at most 1 cm over its edges (things of up to 5 cm hang over, but their middle lies on
//             it), and stands beside the opening of a top such as a basin's, or lies across it from rim to rim
//   headroom  a ceiling piece lower than 1.9 m hangs over furniture

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

// Uses met: whether one can use the pieces as one uses them. What a use is, is said by sentences (Sentence.use, and
// those of origin IMPLIED); whether it is met, by the outcomes of their calls. A sentence whose pieces are not all
// placed is no use; one that no call was made of, or of which a call does not hold, is not met.

// Beside what sentences say, one gets in by the door, and to each piece that one sits, lies or works at, from any side.
struct UsesOfWays {
  int asked = 0, met = 0;
  // Of no sentence. Of a blocked door, only that: with what is in its way, and the door as the partner; of a piece,
  // with what is in the way as the partner.
  std::vector<v1::Finding> unmet;
};

UsesOfWays FindUsesOfWays(const LayoutView& view);

// Counts the uses and adds a finding for each that is not met: of ways before all others, then in the order of the
// sentences. `outcomes` holds one per edge of the graph, in its order.
void AddUses(const v1::LayoutGraph& graph, const google::protobuf::RepeatedPtrField<v1::Placement>& placements,
             const google::protobuf::RepeatedPtrField<v1::EdgeOutcome>& outcomes, v1::LayoutMetrics& metrics);

// [Paper] pathway cost: how much furniture stands on the ways through the room.
//   cost = sum over pieces of ways  length * sum_{k=-3..3} w_k depth(p + 0.1 k n)^2        [m3],  w = 1 2 3 4 3 2 1
//   p, n   middle of the piece and the direction across it;  ways: see FindWays
//   depth  distance of a point inside a solid floor object to its outline; 0 outside
// 0 when nothing stands within 0.3 m of a way. The released function sums over samples instead of length, which makes
// it jump when something moves by a millimetre, pays for rugs, and needs exactly one door (SEMANTICS.md section 7).

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

// Pieces of at most 0.05 m on the floor and outside of objects, without ways that are wider. Deterministic; exact to
// the samples' spacing of 0.018 m.
std::vector<WayPiece> FindWays(const LayoutView& view, double widest_m = std::numeric_limits<double>::infinity());

}  // namespace flair::evaluation
