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
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) free_[At(row, column)] = IsFloor(scene, keep_out, row, column);
    }
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
  bool IsFloor(const Scene& scene, const KeepOut& keep_out, int row, int column) const {
    const Vec2<double> p = CenterOf(row, column);
    if (!Contains(scene.room.floor, p)) return false;
    for (const ConvexPiece& area : keep_out.door_areas()) {
      if (Contains(Polygon{area.vertices}, p)) return false;
    }
    return true;
  }
  void Clear(const Footprint& footprint, const Pose<double>& pose) {
    const Frame<double> frame = FrameOf(pose);
    const double half = cell_m_ / 2 * (std::abs(frame.right.x) + std::abs(frame.right.y)) - 1e-9;
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
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
