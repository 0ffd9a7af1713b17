// SPDX-License-Identifier: GPL-3.0-or-later
// The floor of a furnished room as somebody walks it: a disc of 0.6 m that no solid object and no wall may cut. A gap
// of exactly 0.6 m lets it through.
#pragma once

#include "evaluation/metrics/layout_view.h"
#include "evaluation/metrics/walk_raster.h"

namespace flair::evaluation {

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
