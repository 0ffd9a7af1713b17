// SPDX-License-Identifier: GPL-3.0-or-later
// Promising poses for one object: where a designer would try it. The discrete guess (which wall, which side of the
// table) matters more than the local solve, so many are proposed and each is judged by the true cost.
#pragma once

#include <span>
#include <vector>

#include "optimizer_worker/solver/random.h"
#include "room/scene/scene.h"

namespace flair::optimizer {

// What is known when an object is to be placed.
struct CandidateContext {
  const Scene& scene;
  const Layout& layout;
  // Objects that have a pose.
  std::span<const int> placed;
  // Objects that an edge names together with this one; those without a pose are skipped.
  std::span<const int> partners;
  // Means of the zones; far away for empty zones.
  std::span<const Vec2<double>> zone_centers;
  // What is to be placed instead of the object's own footprint: the box round a group; null for the object's.
  const Footprint* box = nullptr;
};

// How many of each kind to propose.
struct CandidateDensity {
  int wall_samples = 3;
  int floor_samples = 20;
  int partner_samples = 1;
};

// Appends poses for objects of any kind:
//  - floor: back, left or right side flush on each wall (corners, middle, beside openings and neighbours, before
//  partners), each side
//    at each side of each partner (touching and at some distance), and spread over the floor, at cardinal headings;
//  - rugs: under and before each partner, at the middles of the room and of the zone, spread over the floor;
//  - wall: on each wall at partners' and zones' projections, between and beside openings, spread along it;
//  - ceiling: above partners, at the middles of the room and the zones, spread;
//  - surface: at the middle, corners and edges of its host and partners.
void ProposeCandidates(const CandidateContext& context, int object, const CandidateDensity& density, Random& random,
                       std::vector<Pose<double>>& out);

// Appends poses of a floor object slid from `pose` in each direction until it touches what is there, and until it
// leaves `way_m` before it. Only neighbours and walls at multiples of 90 degrees are seen.
void ProposeSlides(const CandidateContext& context, int object, const Pose<double>& pose, double way_m,
                   std::vector<Pose<double>>& out);

// Appends slides off each corner of a wall that juts into the room and that is seen across one of the object's corners,
// nearer than `way_m`, until that much is left: along either axis of the object, and straight away. None in a
// rectangle.
void ProposeSlidesOffCorners(const Room& room, const Footprint& footprint, const Pose<double>& pose, double way_m,
                             std::vector<Pose<double>>& out);

// Appends small moves of `pose`: along and across its heading, by 1 to 40 cm.
void ProposeNudges(const Pose<double>& pose, Random& random, std::vector<Pose<double>>& out);

}  // namespace flair::optimizer
