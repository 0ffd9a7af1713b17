// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/measure/floor_shape.h"

#include <algorithm>

namespace flair::optimizer {
namespace {

constexpr double kFarOut_m = 100;
constexpr double kSmall = 1e-9;

// Indices of the vertices on the convex hull, those in the middle of its edges too, counter-clockwise (walk of Andrew
// over sorted points, kept as indices).
std::vector<size_t> HullOf(const std::vector<Vec2<double>>& v) {
  std::vector<size_t> order(v.size());
  for (size_t i = 0; i < v.size(); ++i) order[i] = i;
  std::ranges::sort(order, [&v](size_t a, size_t b) { return v[a].x != v[b].x ? v[a].x < v[b].x : v[a].y < v[b].y; });
  std::vector<size_t> hull;
  const auto extend = [&v, &hull](size_t i, size_t base) {
    while (hull.size() >= base + 2 &&
           Cross(v[hull.back()] - v[hull[hull.size() - 2]], v[i] - v[hull.back()]) < -kSmall) {
      hull.pop_back();
    }
    hull.push_back(i);
  };
  for (size_t i : order) extend(i, 0);
  const size_t upper = hull.size() - 1;
  for (size_t k = order.size() - 1; k-- > 0;) extend(order[k], upper);
  hull.pop_back();
  std::ranges::sort(hull);  // hull order equals floor order for a counter-clockwise simple polygon
  return hull;
}

bool IsWall(const Polygon& floor, const Vec2<double>& from, const Vec2<double>& to) {
  // A pocket lies on the other side of a wall: it runs along it backwards, on all or a part of it.
  for (size_t i = 0; i < floor.vertices.size(); ++i) {
    const Segment wall = EdgeAt(floor, i);
    if (DistanceTo(wall, from) < kSmall && DistanceTo(wall, to) < kSmall) return true;
  }
  return false;
}

// Joins triangles along shared edges while the result stays convex.
std::vector<Polygon> MergeConvex(std::vector<Polygon> pieces) {
  const auto try_merge = [](const Polygon& a, const Polygon& b) -> Polygon {
    const size_t n = a.vertices.size(), m = b.vertices.size();
    for (size_t i = 0; i < n; ++i) {
      for (size_t j = 0; j < m; ++j) {
        if (!(a.vertices[i] == b.vertices[(j + 1) % m] && a.vertices[(i + 1) % n] == b.vertices[j])) continue;
        Polygon joined;
        for (size_t k = 1; k <= n; ++k) joined.vertices.push_back(a.vertices[(i + k) % n]);
        for (size_t k = 2; k < m; ++k) joined.vertices.push_back(b.vertices[(j + k) % m]);
        if (IsConvex(joined)) return joined;
      }
    }
    return {};
  };
  for (bool merged = true; merged;) {
    merged = false;
    for (size_t i = 0; i < pieces.size() && !merged; ++i) {
      for (size_t j = i + 1; j < pieces.size() && !merged; ++j) {
        Polygon joined = try_merge(pieces[i], pieces[j]);
        if (joined.vertices.empty()) continue;
        pieces[i] = std::move(joined);
        pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(j));
        merged = true;
      }
    }
  }
  return pieces;
}

// Whether a half-plane has the edge line of one that is there: its hull edge has a vertex in the middle.
bool Repeats(const std::vector<FloorShape::HalfPlane>& planes, const FloorShape::HalfPlane& plane) {
  return std::ranges::any_of(planes, [&plane](const FloorShape::HalfPlane& other) {
    return Norm(other.normal - plane.normal) < kSmall &&
           std::abs(Dot(plane.normal, plane.point - other.point)) < kSmall;
  });
}

// Replaces the hull edge a -> b of a piece, if it has it, by a strip far out, when that keeps it convex.
Polygon Extended(const Polygon& piece, const Vec2<double>& a, const Vec2<double>& b) {
  const Vec2<double> d = b - a;
  const Vec2<double> far = (-kFarOut_m / Norm(d)) * Perpendicular(d);
  Polygon result;
  for (size_t i = 0; i < piece.vertices.size(); ++i) {
    const auto [p, q] = EdgeAt(piece, i);
    result.vertices.push_back(p);
    if (p == a && q == b) {
      result.vertices.push_back(a + far);
      result.vertices.push_back(b + far);
    }
  }
  return IsConvex(result) ? result : piece;
}

constexpr double kBehind_m = 10;
constexpr double kOnWall_m = 1e-9;

// A convex area of which one edge lies on the wall, extended behind it.
ConvexPiece AreaAtWall(const Polygon& area, const Wall& wall) {
  Polygon extended;
  for (size_t i = 0; i < area.vertices.size(); ++i) {
    const auto [p, q] = EdgeAt(area, i);
    extended.vertices.push_back(p);
    if (std::abs(wall.Height(p)) < kOnWall_m && std::abs(wall.Height(q)) < kOnWall_m) {
      extended.vertices.push_back(p - kBehind_m * wall.inward_normal);
      extended.vertices.push_back(q - kBehind_m * wall.inward_normal);
    }
  }
  ConvexPiece piece(extended);
  for (size_t i = 0; i < piece.normals.size(); ++i) {
    if (Dot(piece.normals[i], wall.inward_normal) < -0.5 && wall.Height(piece.vertices[i]) < -kOnWall_m) {
      piece.exits[i] = false;
    }
  }
  return piece;
}

}  // namespace

FloorShape::FloorShape(const Polygon& floor) {
  const std::vector<Vec2<double>>& v = floor.vertices;
  const std::vector<size_t> hull = HullOf(v);
  for (size_t k = 0; k < hull.size(); ++k) {
    const size_t i = hull[k], j = hull[(k + 1) % hull.size()];
    const Vec2<double> d = v[j] - v[i];
    const HalfPlane plane{(1 / Norm(d)) * Perpendicular(d), v[i]};
    if (!Repeats(half_planes_, plane)) half_planes_.push_back(plane);
    // The floor's vertices between two neighbours on the hull bound a pocket, walked backwards.
    Polygon pocket;
    for (size_t m = j; m != i; m = (m + v.size() - 1) % v.size()) pocket.vertices.push_back(v[m]);
    pocket.vertices.push_back(v[i]);
    if (pocket.vertices.size() < 3) continue;
    for (const Polygon& part : MergeConvex(Triangulate(pocket))) {
      ConvexPiece piece(Extended(part, v[i], v[j]));
      for (size_t e = 0; e < piece.vertices.size(); ++e) {
        piece.exits[e] = IsWall(floor, piece.vertices[e], piece.vertices[(e + 1) % piece.vertices.size()]);
      }
      pockets_.push_back(std::move(piece));
    }
  }
}

ConvexPiece StripAtWall(const Wall& wall, double start_m, double end_m, double depth_m) {
  const Vec2<double> inward = depth_m * wall.inward_normal;
  const Vec2<double> a = wall.PointAt(start_m), b = wall.PointAt(end_m);
  return AreaAtWall({{a, b, b + inward, a + inward}}, wall);
}

std::vector<ConvexPiece> SwingPieces(const Room& room) {
  std::vector<ConvexPiece> swings;
  for (const Opening& opening : room.openings) {
    for (const Polygon& swing : ConvexSwingAreas(room, opening)) {
      swings.push_back(AreaAtWall(swing, room.walls[static_cast<size_t>(opening.wall)]));
    }
  }
  return swings;
}

std::vector<ConvexPiece> DoorAreas(const Room& room, double passage_m) {
  std::vector<ConvexPiece> areas = SwingPieces(room);
  for (const Opening& opening : room.openings) {
    if (opening.kind != OpeningKind::kDoor) continue;
    areas.push_back(AreaAtWall(PassageArea(room, opening, passage_m), room.walls[static_cast<size_t>(opening.wall)]));
  }
  return areas;
}

}  // namespace flair::optimizer
