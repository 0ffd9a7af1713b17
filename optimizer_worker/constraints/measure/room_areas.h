// SPDX-License-Identifier: GPL-3.0-or-later
// Areas at the walls that objects keep out of. Each reaches far behind its wall and can be left into the room or
// along the wall only, never through the wall.
#pragma once

#include "optimizer_worker/constraints/measure/convex_piece.h"
#include "room/scene/room.h"

namespace flair::optimizer {

// A convex area of which one edge lies on the wall, extended behind it.
ConvexPiece AreaAtWall(const Polygon& area, const Wall& wall);

// The rectangle over [start_m, end_m] of a wall, `depth_m` into the room.
ConvexPiece StripAtWall(const Wall& wall, double start_m, double end_m, double depth_m);

}  // namespace flair::optimizer
