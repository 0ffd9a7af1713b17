// SPDX-License-Identifier: GPL-3.0-or-later
// Which way somebody takes from the door to the front of each solid object: the shortest on the floor as it is walked
// (walk_floor.h), by steps to the eight neighbours of a cell, then pulled taut. Its middle line keeps 0.3 m from
// everything solid, less half a cell.
#pragma once

#include <string>
#include <vector>

#include "evaluation/metrics/layout_view.h"

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

}  // namespace flair::evaluation
