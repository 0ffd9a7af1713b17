// SPDX-License-Identifier: GPL-3.0-or-later
// A straight piece between two points, and distances to it. Exact for degenerate (zero length) segments too.
#pragma once

#include <algorithm>

#include "room/geometry/vec2.h"

namespace flair {

struct Segment {
  Vec2<double> start;
  Vec2<double> end;

  double length_m() const { return Distance(start, end); }
  Vec2<double> Middle() const { return {(start.x + end.x) / 2, (start.y + end.y) / 2}; }
};

// The point of the segment nearest to p.
inline Vec2<double> NearestPoint(const Segment& s, const Vec2<double>& p) {
  const Vec2<double> d = s.end - s.start;
  const double length2 = SquaredNorm(d);
  if (length2 == 0) return s.start;
  const double t = std::clamp(Dot(p - s.start, d) / length2, 0.0, 1.0);
  return {s.start.x + t * d.x, s.start.y + t * d.y};
}

inline double DistanceTo(const Segment& s, const Vec2<double>& p) { return Distance(p, NearestPoint(s, p)); }

// Whether the two share a point; touching counts.
bool Intersects(const Segment& a, const Segment& b);

// Least distance between points of the two; 0 when they intersect.
double DistanceBetween(const Segment& a, const Segment& b);

}  // namespace flair
