// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/geometry/segment.h"

namespace flair {
namespace {

double Turn(const Vec2<double>& a, const Vec2<double>& b, const Vec2<double>& c) { return Cross(b - a, c - a); }

bool WithinBox(const Segment& s, const Vec2<double>& p) {
  return std::min(s.start.x, s.end.x) <= p.x && p.x <= std::max(s.start.x, s.end.x) &&
         std::min(s.start.y, s.end.y) <= p.y && p.y <= std::max(s.start.y, s.end.y);
}

}  // namespace

bool Intersects(const Segment& a, const Segment& b) {
  const double a_start = Turn(b.start, b.end, a.start);
  const double a_end = Turn(b.start, b.end, a.end);
  const double b_start = Turn(a.start, a.end, b.start);
  const double b_end = Turn(a.start, a.end, b.end);
  if (((a_start > 0 && a_end < 0) || (a_start < 0 && a_end > 0)) &&
      ((b_start > 0 && b_end < 0) || (b_start < 0 && b_end > 0))) {
    return true;
  }
  return (a_start == 0 && WithinBox(b, a.start)) || (a_end == 0 && WithinBox(b, a.end)) ||
         (b_start == 0 && WithinBox(a, b.start)) || (b_end == 0 && WithinBox(a, b.end));
}

double DistanceBetween(const Segment& a, const Segment& b) {
  if (Intersects(a, b)) return 0;
  return std::min({DistanceTo(a, b.start), DistanceTo(a, b.end), DistanceTo(b, a.start), DistanceTo(b, a.end)});
}

}  // namespace flair
