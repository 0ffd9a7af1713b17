// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/free_place.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "room/geometry/polygon.h"

namespace flair::optimizer {
namespace {

// Coarser in very large rooms, so that the raster has at most 400 cells a side.
constexpr double kCell_m = 0.05;
constexpr double kMostCells = 400;

// Cells as squares; one is free when its centre, grown by half a cell, is.
class FreeRaster {
 public:
  FreeRaster(const Scene& scene, const KeepOut& keep_out, std::span<const int> standing, const Layout& layout)
      : box_(BoundsOf(scene.room.floor)),
        cell_m_(std::max(kCell_m, std::max(box_.width_m(), box_.height_m()) / kMostCells)),
        columns_(static_cast<int>(box_.width_m() / cell_m_)),
        rows_(static_cast<int>(box_.height_m() / cell_m_)),
        free_(static_cast<size_t>(columns_) * rows_, 1) {
    TakeFloor(scene.room.floor);
    for (const ConvexPiece& area : keep_out.door_areas()) TakeAway(Polygon{area.vertices});
    for (int object : standing) Clear(scene.objects[object].footprint, layout[object]);
  }

  // The largest rectangle under the histogram of each row, by a stack of rising columns.
  FreePlace Largest() const {
    FreePlace best;
    std::vector<int> height(columns_ + 1, 0), open;
    for (int row = 0; row < rows_; ++row) {
      for (int c = 0; c < columns_; ++c) height[c] = free_[At(row, c)] ? height[c] + 1 : 0;
      open.clear();
      for (int c = 0; c <= columns_; ++c) {
        while (!open.empty() && height[open.back()] >= height[c]) {
          const int tall = height[open.back()];
          open.pop_back();
          Offer(tall, open.empty() ? c : c - open.back() - 1, best);
        }
        open.push_back(c);
      }
    }
    return best;
  }

 private:
  size_t At(int row, int column) const { return static_cast<size_t>(row) * columns_ + column; }
  Vec2<double> CenterOf(int row, int column) const {
    return {box_.min.x + (column + 0.5) * cell_m_, box_.min.y + (row + 0.5) * cell_m_};
  }
  // Cells [first, last) of a row or column that may hold points from `low_m` to `high_m`; two more at either end.
  struct Range {
    int first, last;
  };
  Range Cells(double low_m, double high_m, int count) const {
    const auto cell = [&](double at) { return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(count))); };
    return {cell(low_m / cell_m_ - 2), cell(high_m / cell_m_ + 2)};
  }
  void TakeFloor(const Polygon& floor) {
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_;) {
        const Vec2<double> p = CenterOf(row, column);
        const char free = Contains(floor, p) ? 1 : 0;
        // No side of the floor is nearer than this: so many cells have the same answer.
        const int same = std::max(1, static_cast<int>(std::abs(SignedDistance(floor, p)) / cell_m_) - 1);
        for (const int end = std::min(columns_, column + same); column < end; ++column) free_[At(row, column)] = free;
      }
    }
  }
  void TakeAway(const Polygon& area) {
    const BoundingBox box = BoundsOf(area);
    const Range rows = Cells(box.min.y - box_.min.y, box.max.y - box_.min.y, rows_);
    const Range columns = Cells(box.min.x - box_.min.x, box.max.x - box_.min.x, columns_);
    for (int row = rows.first; row < rows.last; ++row) {
      for (int column = columns.first; column < columns.last; ++column) {
        if (Contains(area, CenterOf(row, column))) free_[At(row, column)] = 0;
      }
    }
  }
  void Clear(const Footprint& footprint, const Pose<double>& pose) {
    const Frame<double> frame = FrameOf(pose);
    const double half = cell_m_ / 2 * (std::abs(frame.right.x) + std::abs(frame.right.y)) - 1e-9;
    const double reach_m = CircumscribedRadius(footprint), x = pose.x_m - box_.min.x, y = pose.y_m - box_.min.y;
    const Range rows = Cells(y - reach_m, y + reach_m, rows_), columns = Cells(x - reach_m, x + reach_m, columns_);
    for (int row = rows.first; row < rows.last; ++row) {
      for (int column = columns.first; column < columns.last; ++column) {
        const Vec2<double> local = frame.ToObject(CenterOf(row, column));
        const bool covered =
            std::abs(local.x) < footprint.width_m / 2 + half && std::abs(local.y) < footprint.depth_m / 2 + half;
        if (covered) free_[At(row, column)] = 0;
      }
    }
  }
  void Offer(int rows, int columns, FreePlace& best) const {
    const double a = rows * cell_m_, b = columns * cell_m_;
    if (a * b > best.long_m * best.short_m) best = {std::max(a, b), std::min(a, b)};
  }

  BoundingBox box_;
  double cell_m_;
  int columns_, rows_;
  std::vector<char> free_;
};

}  // namespace

FreePlace LargestFreePlace(const Scene& scene, const KeepOut& keep_out, std::span<const int> standing,
                           const Layout& layout) {
  return FreeRaster(scene, keep_out, standing, layout).Largest();
}

}  // namespace flair::optimizer
