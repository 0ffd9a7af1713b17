// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluation/metrics/walk_floor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

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

constexpr double kCell_m = 0.025;
constexpr double kMostCellsAcross = 1000;

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

WalkRaster::WalkRaster(const BoundingBox& bounds) : bounds_(bounds) {
  cell_m_ = std::max(kCell_m, std::max(bounds.width_m(), bounds.height_m()) / kMostCellsAcross);
  columns_ = std::max(1, static_cast<int>(std::lround(bounds.width_m() / cell_m_)));
  rows_ = std::max(1, static_cast<int>(std::lround(bounds.height_m() / cell_m_)));
  column_m_ = bounds.width_m() / columns_;
  row_m_ = bounds.height_m() / rows_;
}

int WalkRaster::Column(double x_m) const {
  return static_cast<int>(std::clamp((x_m - bounds_.min.x) / column_m_, 0.0, columns_ - 1.0));
}

int WalkRaster::Row(double y_m) const {
  return static_cast<int>(std::clamp((y_m - bounds_.min.y) / row_m_, 0.0, rows_ - 1.0));
}

std::vector<int32_t> WalkRaster::Components(const CellSet& cells, std::vector<int>& sizes) const {
  std::vector<int32_t> labels(cells.size(), 0);
  std::vector<size_t> open;
  sizes.assign(1, 0);
  const auto columns = static_cast<size_t>(columns_);
  for (size_t seed = 0; seed < cells.size(); ++seed) {
    if (!cells[seed] || labels[seed] != 0) continue;
    const auto label = static_cast<int32_t>(sizes.size());
    sizes.push_back(0);
    open.push_back(seed);
    labels[seed] = label;
    const auto visit = [&](size_t cell) {
      if (!cells[cell] || labels[cell] != 0) return;
      labels[cell] = label;
      open.push_back(cell);
    };
    while (!open.empty()) {
      const size_t cell = open.back();
      open.pop_back();
      ++sizes.back();
      if (cell % columns > 0) visit(cell - 1);
      if (cell % columns + 1 < columns) visit(cell + 1);
      if (cell >= columns) visit(cell - columns);
      if (cell + columns < cells.size()) visit(cell + columns);
    }
  }
  return labels;
}

CellSet WalkRaster::Dilate(const CellSet& cells, double radius_m) const {
  // Half the disc's chord, in cells, by how many rows it is from the middle.
  const int reach = static_cast<int>(std::floor(radius_m / cell_m_ + 1e-9));
  std::vector<int> half;
  for (int d = 0; d <= reach; ++d) {
    const double chord_m = std::sqrt(std::max(0.0, radius_m * radius_m - d * d * cell_m_ * cell_m_));
    half.push_back(static_cast<int>(std::floor(chord_m / cell_m_ + 1e-9)));
  }
  // A run of cells in a row becomes a run in each row near by, longer by the half chord at both ends.
  CellSet result(cells.size(), 0);
  for (int r = 0; r < rows_; ++r) {
    for (int c = 0; c < columns_; ++c) {
      if (!cells[IndexOf(c, r)]) continue;
      const int begin = c;
      while (c < columns_ && cells[IndexOf(c, r)]) ++c;
      for (int near = std::max(0, r - reach); near <= std::min(rows_ - 1, r + reach); ++near) {
        const int widen = half[static_cast<size_t>(std::abs(near - r))];
        const auto row = result.begin() + static_cast<std::ptrdiff_t>(IndexOf(0, near));
        std::fill(row + std::max(0, begin - widen), row + std::min(columns_, c + widen), char{1});
      }
    }
  }
  return result;
}

}  // namespace flair::evaluation
