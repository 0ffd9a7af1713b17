// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <span>

namespace flair::renderer {

// A point or offset. Names say the frame: `_m` is room frame R (x east, y north, metres), `_mm` is sheet frame S (x
// right, y down from the sheet's upper left corner, millimetres of paper).
struct Point {
  double x = 0;
  double y = 0;
  friend bool operator==(const Point&, const Point&) = default;
};

inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
inline Point operator*(Point a, double factor) { return {a.x * factor, a.y * factor}; }
inline double Dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
inline double Cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }

struct Size {
  double width = 0;
  double height = 0;
};

// An axis-parallel rectangle; empty when x1 < x0.
struct Box {
  double x0 = 0;
  double y0 = 0;
  double x1 = -1;
  double y1 = -1;

  double width() const { return x1 - x0; }
  double height() const { return y1 - y0; }
  bool empty() const { return x1 < x0; }
  Point centre() const { return {(x0 + x1) / 2, (y0 + y1) / 2}; }
  Box Grown(double by) const { return {x0 - by, y0 - by, x1 + by, y1 + by}; }
  bool Contains(const Box& other) const { return other.x0 >= x0 && other.x1 <= x1 && other.y0 >= y0 && other.y1 <= y1; }
  bool Overlaps(const Box& other) const { return x0 < other.x1 && other.x0 < x1 && y0 < other.y1 && other.y0 < y1; }
  void Include(Point point) {
    if (empty()) {
      *this = {point.x, point.y, point.x, point.y};
      return;
    }
    x0 = std::min(x0, point.x), x1 = std::max(x1, point.x);
    y0 = std::min(y0, point.y), y1 = std::max(y1, point.y);
  }
};

inline Box BoxAround(Point centre, Size size) {
  return {centre.x - size.width / 2, centre.y - size.height / 2, centre.x + size.width / 2, centre.y + size.height / 2};
}

inline Box BoundsOf(std::span<const Point> points) {
  Box bounds;
  for (Point point : points) bounds.Include(point);
  return bounds;
}

// Whether the point lies in the polygon (even-odd rule; points on the border may go either way).
inline bool PolygonContains(std::span<const Point> polygon, Point point) {
  bool inside = false;
  for (size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Point a = polygon[i], b = polygon[j];
    if ((a.y > point.y) != (b.y > point.y) && point.x < a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y))
      inside = !inside;
  }
  return inside;
}

}  // namespace flair::renderer
