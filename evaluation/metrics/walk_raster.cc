// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluation/metrics/walk_raster.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace flair::evaluation {
namespace {

constexpr double kCell_m = 0.025;
constexpr double kMostCellsAcross = 1000;

}  // namespace

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
