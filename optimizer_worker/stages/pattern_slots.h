// SPDX-License-Identifier: GPL-3.0-or-later
// Orderly places for a number of equal boxes in a room.
#pragma once

#include <functional>
#include <vector>

#include "room/geometry/polygon.h"
#include "room/geometry/pose.h"
#include "room/scene/room.h"

namespace flair::optimizer {

using VisitSlots = std::function<void(const std::vector<Pose<double>>&)>;

// Where grids have ways between their boxes.
enum class Ways {
  kNone,      // some have none
  kSideways,  // not side by side without a gap
  kAllRound,  // nor one behind the other
};

// Calls visit(slots) for each pattern of at least `count` boxes; a slot is the pose of the origin in whose frame `box`
// is given. Grids of all numbers of columns, at quarter turns from the longest wall: rows that look the same way or, in
// banks, at each other; without gaps, with ways, or spread over the room; in the middle, at the sides and in the
// corners. Rows along one wall after the other, from each wall on. Slots of a rectangular room do not overlap; they may
// be in the way of doors and of what stands, which is why there may be more than `count`.
void ForEachPattern(const Room& room, const BoundingBox& box, int count, Ways ways, const VisitSlots& visit);

}  // namespace flair::optimizer
