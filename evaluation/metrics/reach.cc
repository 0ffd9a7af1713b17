// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluation/metrics/reach.h"

#include <numeric>

#include "evaluation/metrics/walk_floor.h"

namespace flair::evaluation {
namespace {

bool FrontReached(const LayoutView& view, size_t i, const WalkFloor& floor) {
  bool found = false;
  FrontStrip(view, i).ForCells(floor.raster,
                               [&](size_t cell, const Vec2<double>&) { found |= floor.reached[cell] != 0; });
  return found;
}

int Count(const CellSet& cells) { return std::accumulate(cells.begin(), cells.end(), 0); }

}  // namespace

Reach MeasureReach(const LayoutView& view) {
  const WalkFloor floor = MakeWalkFloor(view);
  CellSet swept = floor.raster.Dilate(floor.reached, kPersonRadius_m);
  for (size_t i = 0; i < swept.size(); ++i) swept[i] = swept[i] && floor.free[i];

  Reach result;
  const int free_count = Count(floor.free);
  if (free_count > 0) result.floor_share = static_cast<double>(Count(swept)) / free_count;
  int tested = 0;
  for (size_t i = 0; i < view.scene.objects.size(); ++i) {
    if (!view.Has(i) || !IsSolid(view.scene.objects[i])) continue;
    ++tested;
    if (!FrontReached(view, i, floor)) result.blocked.push_back(view.scene.objects[i].id);
  }
  if (tested > 0) result.front_share = 1 - static_cast<double>(result.blocked.size()) / tested;
  return result;
}

}  // namespace flair::evaluation
