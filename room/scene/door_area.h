// SPDX-License-Identifier: GPL-3.0-or-later
// The floor that a door needs: what its leaf sweeps, and the passage in front of it.
#pragma once

#include <vector>

#include "room/geometry/polygon.h"
#include "room/scene/room.h"

namespace flair {

// The end of the opening that carries the hinges, on the floor's edge. The start when there is no leaf.
Vec2<double> HingePoint(const Room& room, const Opening& door);

// The sector of radius width_m that the leaf sweeps inside the room, as a polygon around the arc (so that it covers the
// arc: at most 0.3 % of the radius too large), counter-clockwise. Empty for doors that do not open inwards.
Polygon SwingArea(const Room& room, const Opening& door, int arc_pieces = 8);

// The same in convex pieces: a leaf that opens wider than a half turn minus the wall is not convex any more.
std::vector<Polygon> ConvexSwingAreas(const Room& room, const Opening& door, int arc_pieces = 8);

// The rectangle in front of the opening, `depth_m` into the room, widened by `margin_m` at both ends. Convex.
Polygon PassageArea(const Room& room, const Opening& door, double depth_m, double margin_m = 0);

}  // namespace flair
