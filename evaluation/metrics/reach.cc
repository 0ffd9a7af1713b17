// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluation/metrics/reach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "evaluation/metrics/walk_raster.h"
#include "room/geometry/footprint.h"
#include "room/scene/door_area.h"

namespace flair::evaluation {
namespace {

constexpr double kPersonRadius_m = 0.3;
constexpr double kDoorFront_m = 0.6;
constexpr double kFrontStrip_m = 0.6;
constexpr double kLeastStripHalfWidth_m = 0.15;

// Free floor, and where the centre of a person can be.
struct Floor {
  CellSet free;
  CellSet roomy;
};

Floor EmptyFloor(const Room& room, const WalkRaster& raster, double radius_m) {
  Floor floor{CellSet(raster.size(), 0), CellSet(raster.size(), 0)};
  for (int r = 0; r < raster.rows(); ++r) {
    for (int c = 0; c < raster.columns();) {
      const double distance = SignedDistance(room.floor, raster.CenterOf(c, r));
      const char free = distance >= 0, roomy = distance >= radius_m;
      // The distance changes by no more than the way walked: for so many cells the answers stay the same.
      const double to_change = std::min(std::abs(distance), std::abs(distance - radius_m));
      const int same = std::max(1, static_cast<int>(to_change / raster.column_m()) - 1);
      for (const int end = std::min(raster.columns(), c + same); c < end; ++c) {
        floor.free[raster.IndexOf(c, r)] = free;
        floor.roomy[raster.IndexOf(c, r)] = roomy;
      }
    }
  }
  return floor;
}

void TakeAway(const LayoutView& view, size_t i, const WalkRaster& raster, double radius_m, Floor& floor) {
  const Footprint& footprint = view.scene.objects[i].footprint;
  const Frame<double> frame = FrameOf(view.layout[i]);
  const auto corners = Corners(footprint, frame);
  raster.ForCellsNear(BoundsOf(corners), radius_m, [&](size_t cell, const Vec2<double>& p) {
    const Vec2<double> local = frame.ToObject(p);
    const double du = std::max(0.0, std::abs(local.x) - footprint.width_m / 2);
    const double dv = std::max(0.0, std::abs(local.y) - footprint.depth_m / 2);
    if (du == 0 && dv == 0) floor.free[cell] = 0;
    if (du * du + dv * dv < radius_m * radius_m) floor.roomy[cell] = 0;
  });
}

// The part of `roomy` that one walks in.
CellSet ReachedFrom(const Room& room, const WalkRaster& raster, const CellSet& roomy) {
  std::vector<int> sizes;
  const std::vector<int32_t> labels = raster.Components(roomy, sizes);
  bool has_door = false;
  std::vector<char> begins(sizes.size(), 0);
  for (const Opening& door : room.openings) {
    if (door.kind != OpeningKind::kDoor) continue;
    has_door = true;
    const Polygon landing = PassageArea(room, door, kDoorFront_m);
    raster.ForCellsNear(BoundsOf(landing), 0, [&](size_t cell, const Vec2<double>& p) {
      if (Contains(landing, p)) begins[static_cast<size_t>(labels[cell])] = 1;
    });
  }
  size_t best = 0;
  for (size_t k = 1; k < sizes.size(); ++k) {
    if ((begins[k] || !has_door) && sizes[k] > sizes[best]) best = k;
  }
  CellSet reached(roomy.size(), 0);
  if (best == 0) return reached;
  for (size_t i = 0; i < roomy.size(); ++i) reached[i] = labels[i] == static_cast<int32_t>(best);
  return reached;
}

bool FrontReached(const LayoutView& view, size_t i, const WalkRaster& raster, const CellSet& reached) {
  const Footprint& footprint = view.scene.objects[i].footprint;
  const SideEdge<double> edge = EdgeOf(footprint, view.layout[i], Side::kFront);
  const Vec2<double> middle = edge.Middle();
  const double half = std::max(SideLength(footprint, Side::kFront) / 2, kLeastStripHalfWidth_m);
  const Vec2<double> along = Perpendicular(edge.outward_normal);
  const std::array<Vec2<double>, 4> strip = {middle + half * along, middle - half * along,
                                             middle + half * along + kFrontStrip_m * edge.outward_normal,
                                             middle - half * along + kFrontStrip_m * edge.outward_normal};
  bool found = false;
  raster.ForCellsNear(BoundsOf(strip), 0, [&](size_t cell, const Vec2<double>& p) {
    if (found || !reached[cell]) return;
    const double out = Dot(p - middle, edge.outward_normal);
    found = std::abs(Dot(p - middle, along)) <= half && out >= 0 && out <= kFrontStrip_m;
  });
  return found;
}

int Count(const CellSet& cells) { return std::accumulate(cells.begin(), cells.end(), 0); }

}  // namespace

Reach MeasureReach(const LayoutView& view) {
  const Room& room = view.scene.room;
  const WalkRaster raster(BoundsOf(room.floor));
  // Half a cell of slack, so that a gap of exactly the person's width lets it through.
  const double radius_m = kPersonRadius_m - raster.cell_m() / 2 - 1e-7;
  Floor floor = EmptyFloor(room, raster, radius_m);
  for (size_t i = 0; i < view.scene.objects.size(); ++i) {
    if (view.Has(i) && IsSolid(view.scene.objects[i])) TakeAway(view, i, raster, radius_m, floor);
  }
  const CellSet reached = ReachedFrom(room, raster, floor.roomy);
  CellSet swept = raster.Dilate(reached, kPersonRadius_m);
  for (size_t i = 0; i < swept.size(); ++i) swept[i] = swept[i] && floor.free[i];

  Reach result;
  const int free_count = Count(floor.free);
  if (free_count > 0) result.floor_share = static_cast<double>(Count(swept)) / free_count;
  int tested = 0;
  for (size_t i = 0; i < view.scene.objects.size(); ++i) {
    if (!view.Has(i) || !IsSolid(view.scene.objects[i])) continue;
    ++tested;
    if (!FrontReached(view, i, raster, reached)) result.blocked.push_back(view.scene.objects[i].id);
  }
  if (tested > 0) result.front_share = 1 - static_cast<double>(result.blocked.size()) / tested;
  return result;
}

}  // namespace flair::evaluation
