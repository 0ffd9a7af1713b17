// SPDX-License-Identifier: GPL-3.0-or-later
// Which way somebody takes from the door to the front of each solid object: the shortest on the floor as it is walked
// (walk_grid.h), by steps to the eight neighbours of a cell, then pulled taut. Its middle line keeps 0.3 m from
// everything solid, less half a cell.
#pragma once

#include <string>
#include <vector>

#include "evaluation/metrics/layout_metrics.h"

namespace flair::evaluation {

struct Route {
  std::string object_id;
  // From the middle of the door's opening to where one stands before the object.
  std::vector<Vec2<double>> points;
};

struct Routes {
  // In the scene's order; none for objects that are out of reach, none at all without a door.
  std::vector<Route> routes;
  // Objects that cannot be stood at, as Reach has them.
  std::vector<std::string> blocked;
};

// Deterministic.
Routes FindRoutes(const LayoutView& view);

// Where a person 0.6 m wide gets to from the door, on a raster of 0.025 m (coarser beyond 25 m). A gap of exactly 0.6 m
// lets the person through. Shares as the neutral judge of the released rooms has them (recorded_test.cc), so that they
// compare with its figures: a chair pushed under its table counts as out of reach, as its front does.

struct Reach {
  // Share of the free floor that the person's disc sweeps; 1 when no floor is free.
  double floor_share = 1;
  // Share of solid floor objects that can be stood at: a reached position within 0.6 m of the front. 1 when there are
  // none.
  double front_share = 1;
  // Objects that cannot be.
  std::vector<std::string> blocked;
};

// Starts in the 0.6 m before each door; the largest area that begins there counts. Without doors, the largest of all.
Reach MeasureReach(const LayoutView& view);

}  // namespace flair::evaluation
