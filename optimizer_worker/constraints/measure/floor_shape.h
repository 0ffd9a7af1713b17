// SPDX-License-Identifier: GPL-3.0-or-later
// A floor as what keeps objects in: the half-planes of its convex hull, and convex areas that cover everything of the
// hull that is not floor. A rectangle has four half-planes and no areas, so that it gives exactly the formulas of
// the paper; an L has five and one.
#pragma once

#include <cmath>
#include <vector>

#include "room/geometry/convex_piece.h"
#include "room/geometry/gap.h"
#include "room/scene/room.h"

namespace flair::optimizer {

class FloorShape {
 public:
  explicit FloorShape(const Polygon& floor);

  // inside: Dot(normal, p - point) >= 0.
  struct HalfPlane {
    Vec2<double> normal;
    Vec2<double> point;

    // How far a point is outside; negative inside.
    template <typename T>
    T Excess(const Vec2<T>& p) const {
      return (point.x - p.x) * normal.x + (point.y - p.y) * normal.y;
    }
  };
  const std::vector<HalfPlane>& half_planes() const { return half_planes_; }
  // Extended far out of the hull; their edges are exits only where they are walls.
  const std::vector<ConvexPiece>& pockets() const { return pockets_; }

  // Squared distances of a point beyond the half-planes.
  template <typename T>
  T SquaredExcess(const Vec2<T>& p) const {
    T sum(0.0);
    for (const HalfPlane& h : half_planes_) sum += SquaredHinge(h.Excess(p));
    return sum;
  }
  // Of all corners of a box, and its squared penetration of the pockets: 0 exactly when the box is on the floor.
  template <typename T>
  T SquaredExcess(const Box<T>& box) const {
    T sum(0.0);
    for (const HalfPlane& h : half_planes_) {
      // Most objects stand inside: then nothing needs derivatives.
      const double reach = std::abs(Dot(h.normal, box.value_right())) * box.half_width() +
                           std::abs(Dot(h.normal, box.value_front())) * box.half_depth();
      if (h.Excess(box.value_center()) <= -reach) continue;
      for (int i = 0; i < box.count(); ++i) {
        if (h.Excess(box.value(i)) > 0) sum += Square(h.Excess(box.vertex(i)));
      }
    }
    return sum + SquaredPocketDepth(box);
  }
  template <typename T>
  T SquaredPocketDepth(const Box<T>& box) const {
    T sum(0.0);
    for (const ConvexPiece& pocket : pockets_) sum += SquaredPenetration<T>(box, pocket);
    return sum;
  }

 private:
  std::vector<HalfPlane> half_planes_;
  std::vector<ConvexPiece> pockets_;
};

// Areas at the walls that objects keep out of. Each reaches far behind its wall and can be left into the room or
// along the wall only, never through the wall.

// The rectangle over [start_m, end_m] of a wall, `depth_m` into the room.
ConvexPiece StripAtWall(const Wall& wall, double start_m, double end_m, double depth_m);

// How far in front of a door the floor stays free for stepping through.
inline constexpr double kPassage_m = 0.6;

// What the leaves sweep, as convex areas that reach behind the wall.
std::vector<ConvexPiece> SwingPieces(const Room& room);

// Swings and passages of all doors, as convex areas that reach behind the wall.
std::vector<ConvexPiece> DoorAreas(const Room& room, double passage_m = kPassage_m);

}  // namespace flair::optimizer
