// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluation/metrics/walk_floor.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "room/geometry/footprint.h"
#include "room/scene/room.h"

namespace flair::evaluation {
namespace {

constexpr double kDoorFront_m = 0.6;
constexpr double kLeastStripHalfWidth_m = 0.15;

WalkFloor EmptyFloor(const Room& room, double radius_m, const WalkRaster& raster) {
  WalkFloor floor{raster, CellSet(raster.size(), 0), CellSet(raster.size(), 0), {}};
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

void TakeAway(const LayoutView& view, size_t i, double radius_m, WalkFloor& floor) {
  const Footprint& footprint = view.scene.objects[i].footprint;
  const Frame<double> frame = FrameOf(view.layout[i]);
  const auto corners = Corners(footprint, frame);
  floor.raster.ForCellsNear(BoundsOf(corners), radius_m, [&](size_t cell, const Vec2<double>& p) {
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
    ForLanding(raster, LandingOf(room, door),
               [&](size_t cell, const Vec2<double>&) { begins[static_cast<size_t>(labels[cell])] = 1; });
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

}  // namespace

WalkFloor MakeWalkFloor(const LayoutView& view) {
  const Room& room = view.scene.room;
  const WalkRaster raster(BoundsOf(room.floor));
  // Half a cell of slack, so that a gap of exactly the person's width lets it through.
  const double radius_m = kPersonRadius_m - raster.cell_m() / 2 - 1e-7;
  WalkFloor floor = EmptyFloor(room, radius_m, raster);
  for (size_t i = 0; i < view.scene.objects.size(); ++i) {
    if (view.Has(i) && IsSolid(view.scene.objects[i])) TakeAway(view, i, radius_m, floor);
  }
  floor.reached = ReachedFrom(room, raster, floor.roomy);
  return floor;
}

Polygon LandingOf(const Room& room, const Opening& door) { return PassageArea(room, door, kDoorFront_m); }

FrontStrip::FrontStrip(const LayoutView& view, size_t object) {
  const Footprint& footprint = view.scene.objects[object].footprint;
  const SideEdge<double> edge = EdgeOf(footprint, view.layout[object], Side::kFront);
  middle_ = edge.Middle();
  outward_ = edge.outward_normal;
  along_ = Perpendicular(outward_);
  half_width_m_ = std::max(SideLength(footprint, Side::kFront) / 2, kLeastStripHalfWidth_m);
  bounds_ = BoundsOf(std::array<Vec2<double>, 4>{middle_ + half_width_m_ * along_, middle_ - half_width_m_ * along_,
                                                 middle_ + half_width_m_ * along_ + kDepth_m * outward_,
                                                 middle_ - half_width_m_ * along_ + kDepth_m * outward_});
}

}  // namespace flair::evaluation
