// SPDX-License-Identifier: GPL-3.0-or-later
// Nearly square cells that divide the room's bounding box evenly, and sets of them.
#pragma once

#include <cstdint>
#include <vector>

#include "room/geometry/polygon.h"

namespace flair::evaluation {

using CellSet = std::vector<char>;

class WalkRaster {
 public:
  explicit WalkRaster(const BoundingBox& bounds);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  size_t size() const { return static_cast<size_t>(columns_) * static_cast<size_t>(rows_); }
  // Nominal side of a cell; all columns together differ from it by at most half a cell, and so do all rows.
  double cell_m() const { return cell_m_; }
  double column_m() const { return column_m_; }
  Vec2<double> CenterOf(int column, int row) const {
    return {bounds_.min.x + (column + 0.5) * column_m_, bounds_.min.y + (row + 0.5) * row_m_};
  }
  size_t IndexOf(int column, int row) const {
    return static_cast<size_t>(row) * static_cast<size_t>(columns_) + static_cast<size_t>(column);
  }

  // Calls visit(index, centre) for every cell whose centre may be within `reach_m` of the box.
  template <typename Visit>
  void ForCellsNear(const BoundingBox& box, double reach_m, const Visit& visit) const {
    const int c0 = Column(box.min.x - reach_m), c1 = Column(box.max.x + reach_m);
    const int r0 = Row(box.min.y - reach_m), r1 = Row(box.max.y + reach_m);
    for (int r = r0; r <= r1; ++r) {
      for (int c = c0; c <= c1; ++c) visit(IndexOf(c, r), CenterOf(c, r));
    }
  }

  // Numbers the parts of `cells` that hang together over edges, from 1; 0 outside them. `sizes[k]` counts part k.
  std::vector<int32_t> Components(const CellSet& cells, std::vector<int>& sizes) const;

  // All cells whose centre is within `radius_m` of the centre of one in `cells`, counting cells as cell_m() wide.
  CellSet Dilate(const CellSet& cells, double radius_m) const;

 private:
  int Column(double x_m) const;
  int Row(double y_m) const;

  BoundingBox bounds_;
  double cell_m_;
  int columns_;
  int rows_;
  double column_m_;
  double row_m_;
};

}  // namespace flair::evaluation
