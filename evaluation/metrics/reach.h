// SPDX-License-Identifier: GPL-3.0-or-later
// Where a person 0.6 m wide gets to from the door, on a raster of 0.025 m (coarser beyond 25 m). A gap of exactly 0.6 m
// lets the person through. Shares as the neutral judge of the released rooms has them (recorded_test.cc), so that they
// compare with its figures: a chair pushed under its table counts as out of reach, as its front does.
#pragma once

#include <string>
#include <vector>

#include "evaluation/metrics/layout_view.h"

namespace flair::evaluation {

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
