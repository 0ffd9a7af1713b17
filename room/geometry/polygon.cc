// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/geometry/polygon.h"

#include <limits>

namespace flair {
namespace {

double Turn(const Vec2<double>& a, const Vec2<double>& b, const Vec2<double>& c) { return Cross(b - a, c - a); }

bool WithinBox(const Segment& s, const Vec2<double>& p) {
  return std::min(s.start.x, s.end.x) <= p.x && p.x <= std::max(s.start.x, s.end.x) &&
         std::min(s.start.y, s.end.y) <= p.y && p.y <= std::max(s.start.y, s.end.y);
}

bool IsEar(const std::vector<Vec2<double>>& v, size_t i) {
  const size_t n = v.size();
  const Vec2<double>& a = v[(i + n - 1) % n];
  const Vec2<double>& b = v[i];
  const Vec2<double>& c = v[(i + 1) % n];
  if (Cross(b - a, c - b) <= 0) return false;
  for (const Vec2<double>& p : v) {
    if (p == a || p == b || p == c) continue;
    if (Cross(b - a, p - a) >= 0 && Cross(c - b, p - b) >= 0 && Cross(a - c, p - c) >= 0) return false;
  }
  return true;
}

// A vertex in the middle of a straight edge.
bool IsFlat(const std::vector<Vec2<double>>& v, size_t i) {
  const size_t n = v.size();
  return Cross(v[i] - v[(i + n - 1) % n], v[(i + 1) % n] - v[i]) == 0;
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

double SignedArea(std::span<const Vec2<double>> vertices) {
  double twice = 0;
  for (size_t i = 0; i < vertices.size(); ++i) twice += Cross(vertices[i], vertices[(i + 1) % vertices.size()]);
  return twice / 2;
}

double Area(const Polygon& polygon) { return std::abs(SignedArea(polygon.vertices)); }

Vec2<double> Centroid(const Polygon& polygon) {
  const std::vector<Vec2<double>>& v = polygon.vertices;
  Vec2<double> weighted, mean;
  double twice = 0;
  for (size_t i = 0; i < v.size(); ++i) {
    const Vec2<double>& next = v[(i + 1) % v.size()];
    const double cross = Cross(v[i], next);
    twice += cross;
    weighted += cross * (v[i] + next);
    mean += (1.0 / static_cast<double>(v.size())) * v[i];
  }
  return twice == 0 ? mean : (1 / (3 * twice)) * weighted;
}

BoundingBox BoundsOf(std::span<const Vec2<double>> points) {
  if (points.empty()) return {};
  BoundingBox box{points[0], points[0]};
  for (const Vec2<double>& p : points) {
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
  }
  return box;
}

BoundingBox BoundsOf(const Polygon& polygon) { return BoundsOf(std::span(polygon.vertices)); }

Segment EdgeAt(const Polygon& polygon, size_t i) {
  return {polygon.vertices[i], polygon.vertices[(i + 1) % polygon.vertices.size()]};
}

bool Contains(const Polygon& polygon, const Vec2<double>& p) {
  bool inside = false;
  for (size_t i = 0; i < polygon.vertices.size(); ++i) {
    const auto [a, b] = EdgeAt(polygon, i);
    const double turn = Cross(b - a, p - a);
    const bool within = std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
                        p.y <= std::max(a.y, b.y);
    if (turn == 0 && within) return true;
    if ((a.y > p.y) != (b.y > p.y) && (turn > 0) == (b.y > a.y)) inside = !inside;
  }
  return inside;
}

bool IsSimple(const Polygon& polygon) {
  const size_t n = polygon.vertices.size();
  if (n < 3 || SignedArea(polygon.vertices) == 0) return false;
  for (size_t i = 0; i < n; ++i) {
    const Segment a = EdgeAt(polygon, i);
    if (a.start == a.end) return false;
    const Segment next = EdgeAt(polygon, (i + 1) % n);
    // A neighbour may share the vertex only: no spike that runs back along the edge.
    if (Cross(a.end - a.start, next.end - next.start) == 0 && Dot(a.end - a.start, next.end - next.start) < 0)
      return false;
    for (size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      if (Intersects(a, EdgeAt(polygon, j))) return false;
    }
  }
  return true;
}

bool IsConvex(const Polygon& polygon) {
  const size_t n = polygon.vertices.size();
  for (size_t i = 0; i < n; ++i) {
    const Segment a = EdgeAt(polygon, i);
    const Segment b = EdgeAt(polygon, (i + 1) % n);
    if (Cross(a.end - a.start, b.end - b.start) < 0) return false;
  }
  return n >= 3;
}

double DistanceToBoundary(const Polygon& polygon, const Vec2<double>& p) {
  constexpr double kRounding_m = 1e-9;
  double best = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < polygon.vertices.size(); ++i) {
    const Segment edge = EdgeAt(polygon, i);
    const Vec2<double> along = edge.end - edge.start;
    const double off = Cross(along, p - edge.start);
    const double near_m = best + kRounding_m;
    // The edge's whole line is farther away.
    if (off * off > near_m * near_m * SquaredNorm(along)) continue;
    best = std::min(best, DistanceTo(edge, p));
  }
  return best;
}

double SignedDistance(const Polygon& polygon, const Vec2<double>& p) {
  const double distance = DistanceToBoundary(polygon, p);
  return Contains(polygon, p) ? distance : -distance;
}

Polygon ClipByConvex(const Polygon& subject, std::span<const Vec2<double>> clip) {
  Polygon result = subject;
  Polygon next;
  for (size_t k = 0; k < clip.size() && !result.vertices.empty(); ++k) {
    const Vec2<double>& a = clip[k];
    const Vec2<double> direction = clip[(k + 1) % clip.size()] - a;
    next.vertices.clear();
    for (size_t i = 0; i < result.vertices.size(); ++i) {
      const auto [p, q] = EdgeAt(result, i);
      const double side_p = Cross(direction, p - a);
      const double side_q = Cross(direction, q - a);
      if (side_p >= 0) next.vertices.push_back(p);
      if ((side_p > 0 && side_q < 0) || (side_p < 0 && side_q > 0)) {
        next.vertices.push_back(p + (side_p / (side_p - side_q)) * (q - p));
      }
    }
    std::swap(result, next);
  }
  return result;
}

double ConvexIntersectionArea(std::span<const Vec2<double>> a, std::span<const Vec2<double>> b) {
  Polygon subject;
  subject.vertices.assign(a.begin(), a.end());
  return std::abs(SignedArea(ClipByConvex(subject, b).vertices));
}

std::vector<Polygon> Triangulate(const Polygon& polygon) {
  std::vector<Polygon> triangles;
  if (!IsSimple(polygon)) return triangles;
  std::vector<Vec2<double>> v = polygon.vertices;
  if (SignedArea(v) < 0) std::ranges::reverse(v);
  while (v.size() >= 3) {
    bool cut = false;
    for (size_t i = 0; i < v.size() && !cut; ++i) {
      if (IsEar(v, i)) {
        triangles.push_back({{v[(i + v.size() - 1) % v.size()], v[i], v[(i + 1) % v.size()]}});
        cut = true;
      } else if (IsFlat(v, i)) {
        cut = true;
      }
      if (cut) v.erase(v.begin() + static_cast<std::ptrdiff_t>(i));
    }
    if (!cut) break;
  }
  return triangles;
}

std::string_view SideName(Side side) {
  constexpr std::string_view kNames[] = {"front", "back", "left", "right"};
  return kNames[static_cast<size_t>(side)];
}

std::optional<Side> SideFromName(std::string_view name) {
  const auto found = std::ranges::find(kSides, name, SideName);
  return found == std::end(kSides) ? std::nullopt : std::optional(*found);
}

std::string_view CornerName(Corner corner) {
  constexpr std::string_view kNames[] = {"back_left", "back_right", "front_right", "front_left"};
  return kNames[static_cast<size_t>(corner)];
}

std::optional<Corner> CornerFromName(std::string_view name) {
  for (Corner corner : {Corner::kBackLeft, Corner::kBackRight, Corner::kFrontRight, Corner::kFrontLeft}) {
    if (name == CornerName(corner)) return corner;
  }
  return std::nullopt;
}

}  // namespace flair
