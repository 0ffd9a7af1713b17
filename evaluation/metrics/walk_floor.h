// SPDX-License-Identifier: GPL-3.0-or-later
// The floor of a furnished room as somebody walks it: a disc of 0.6 m that no solid object and no wall may cut. A gap
// of exactly 0.6 m lets it through.
#pragma once

#include <cstdint>
#include <vector>

#include "evaluation/metrics/layout_view.h"
#include "room/geometry/polygon.h"

namespace flair::evaluation {

// Nearly square cells that divide the room's bounding box evenly, and sets of them.
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

inline constexpr double kPersonRadius_m = 0.3;

struct WalkFloor {
  WalkRaster raster;
  // Cells that nothing solid stands on.
  CellSet free;
  // Cells where the middle of a person can be.
  CellSet roomy;
  // Those of them that one gets to from the 0.6 m before a door; the largest area that begins there counts. Without
  // doors, the largest of all.
  CellSet reached;
};

WalkFloor MakeWalkFloor(const LayoutView& view);

// Calls visit(cell, centre) for every cell of the 0.6 m before the door.
template <typename Visit>
void ForLanding(const WalkRaster& raster, const Polygon& landing, const Visit& visit) {
  raster.ForCellsNear(BoundsOf(landing), 0, [&](size_t cell, const Vec2<double>& p) {
    if (Contains(landing, p)) visit(cell, p);
  });
}
Polygon LandingOf(const Room& room, const Opening& door);

// The 0.6 m before an object's front, as wide as it and at least 0.3 m: whoever stands there is at the object.
class FrontStrip {
 public:
  FrontStrip(const LayoutView& view, size_t object);
  Vec2<double> middle_of_front() const { return middle_; }
  Vec2<double> outward() const { return outward_; }

  // Calls visit(cell, centre) for every cell of the strip.
  template <typename Visit>
  void ForCells(const WalkRaster& raster, const Visit& visit) const {
    raster.ForCellsNear(bounds_, 0, [&](size_t cell, const Vec2<double>& p) {
      const double out = Dot(p - middle_, outward_);
      if (std::abs(Dot(p - middle_, along_)) <= half_width_m_ && out >= 0 && out <= kDepth_m) visit(cell, p);
    });
  }

 private:
  static constexpr double kDepth_m = 0.6;
  Vec2<double> middle_, outward_, along_;
  double half_width_m_;
  BoundingBox bounds_;
};

}  // namespace flair::evaluation
