// SPDX-License-Identifier: GPL-3.0-or-later
// The areas of a room's zones: Voronoi cells of the zones' mean points, cut to the floor ([Paper] section 3.3).
#pragma once

#include <span>
#include <vector>

#include "room/geometry/polygon.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {

// The disjoint parts of one cell, counter-clockwise. One part in a convex room; a cell that an inner corner cuts has
// several; none when the site's cell misses the floor.
using ZoneCell = std::vector<Polygon>;

// One cell per site: the points of `floor` that are nearer to it than to any other site. `floor` is simple and
// counter-clockwise; sites may lie anywhere. Computed exactly (CGAL, exact constructions) and rounded at the end; parts
// of less than 1e-10 m2 are dropped. Of equal sites the first gets the cell. Thread-safe.
std::vector<ZoneCell> VoronoiZones(const Polygon& floor, std::span<const Vec2<double>> sites);

}  // namespace flair::optimizer
