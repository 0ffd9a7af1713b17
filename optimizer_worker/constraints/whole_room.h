// SPDX-License-Identifier: GPL-3.0-or-later
// The terms that an optimizer adds by itself, one Cost per object or pair. Factors (the paper's lambdas) are the
// caller's. A null result means that the term can never act on these objects.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/pose.h"
#include "room/scene/scene.h"

namespace flair::optimizer {

// What the terms are called, in the catalogue and in outcomes; and the call that asks for what kZoneTerm does.
inline constexpr char kNoOverlapTerm[] = "no_overlap";
inline constexpr char kInBoundsTerm[] = "in_bounds";
inline constexpr char kDoorClearTerm[] = "door_clear";
inline constexpr char kAlignedTerm[] = "aligned";
inline constexpr char kWallAttractionTerm[] = "wall_attraction";
inline constexpr char kBalancedTerm[] = "balanced";
inline constexpr char kOnWallTerm[] = "on_wall";
inline constexpr char kZoneTerm[] = "zone";
inline constexpr char kInZoneCall[] = "in_zone";

// Whether two objects can be in each other's way: same storey of the room, none to walk over, none carrying the other.
bool CanCollide(const Scene& scene, int a, int b);

// The opening in the top of `host` that `object`, which stands on it, keeps off; none when it may be over it: when it
// is meant to be inside, or long enough to lie across.
std::optional<Footprint> OpeningBelow(const Scene& scene, int object, int host);

// depth^2 [m2], see types/room.cc. Null when they cannot collide and neither stands on the other beside an opening.
std::unique_ptr<Cost> NoOverlapPair(const Scene& scene, int a, int b);
// Sum of squared distances outside [m2].
std::unique_ptr<Cost> InBounds(const Scene& scene, int object);
// Penetration^2 into swings and passages [m2]. Null when there is no door or the object is
// above or walked over.
std::unique_ptr<Cost> DoorClear(const Scene& scene, int object);
// sin^2(2 theta) / 5. Null for what stands around something round.
std::unique_ptr<Cost> Aligned(const Scene& scene, int object);
// Squared distance from the nearest wall beyond half a diagonal and 0.5 m [m2].
std::unique_ptr<Cost> WallAttraction(const Scene& scene, int object);
// Squared distance of the centre of mass of the objects to the room's centre [m2]. Null when
// `objects` is empty.
std::unique_ptr<Cost> Balanced(const Scene& scene, std::span<const int> objects);
// Squared differences of distances to zone centres [m2], see types/space.cc. Null for objects without a zone and
// when there is one zone only.
std::unique_ptr<Cost> ZoneAffinity(const Scene& scene, int object, std::span<const Vec2<double>> zone_centers);
// Back on a wall and off the openings [m2], see types/on_wall.cc. Null unless the object is of kind wall.
std::unique_ptr<Cost> OnWall(const Scene& scene, int object);

}  // namespace flair::optimizer
