// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/solver/separation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "room/scene/door_area.h"

namespace flair::optimizer {
namespace {

// Indices of the convex hull of a simple counter-clockwise polygon, counter-clockwise, collinear points left out.
std::vector<size_t> HullOf(const Polygon& polygon) {
  const std::vector<Vec2<double>>& v = polygon.vertices;
  std::vector<size_t> order(v.size());
  for (size_t i = 0; i < v.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](size_t a, size_t b) { return v[a].x != v[b].x ? v[a].x < v[b].x : v[a].y < v[b].y; });
  std::vector<size_t> hull;
  const auto extend = [&](size_t floor_size, size_t i) {
    while (hull.size() >= floor_size + 2 &&
           Cross(v[hull.back()] - v[hull[hull.size() - 2]], v[i] - v[hull.back()]) <= 1e-12) {
      hull.pop_back();
    }
    hull.push_back(i);
  };
  for (size_t i : order) extend(0, i);
  const size_t lower = hull.size() - 1;
  for (size_t k = order.size(); k-- > 0;) extend(lower, order[k]);
  hull.pop_back();
  return hull;
}

// The pockets between the floor and its hull, as triangles.
void AddPockets(const Polygon& floor, const std::vector<size_t>& hull, std::vector<Polygon>& areas) {
  const size_t n = floor.vertices.size();
  for (size_t h = 0; h < hull.size(); ++h) {
    const size_t from = hull[h], to = hull[(h + 1) % hull.size()];
    if ((from + 1) % n == to) continue;
    Polygon pocket;
    for (size_t i = to;; i = (i + n - 1) % n) {
      pocket.vertices.push_back(floor.vertices[i]);
      if (i == from) break;
    }
    if (std::abs(SignedArea(pocket.vertices)) < 1e-12) continue;
    for (Polygon& triangle : Triangulate(pocket)) areas.push_back(std::move(triangle));
  }
}

double SupportAlong(std::span<const Vec2<double>> shape, const Vec2<double>& direction) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Vec2<double>& p : shape) most = std::max(most, Dot(p, direction));
  return most;
}

// Tries the outward normals of `a` as directions to `b`.
void TryNormals(std::span<const Vec2<double>> a, std::span<const Vec2<double>> b, double sign, Gap& best) {
  for (size_t i = 0; i < a.size(); ++i) {
    const Vec2<double> edge = a[(i + 1) % a.size()] - a[i];
    const double length = Norm(edge);
    if (length < 1e-12) continue;
    const Vec2<double> normal{edge.y / length, -edge.x / length};
    const double gap = -SupportAlong(b, -normal) - Dot(a[i], normal);
    if (gap > best.gap_m) best = {sign * normal, gap};
  }
}

}  // namespace

KeepOut::KeepOut(const Room& room, double passage_m) {
  const std::vector<size_t> hull = HullOf(room.floor);
  for (size_t h = 0; h < hull.size(); ++h) {
    const Vec2<double> p = room.floor.vertices[hull[h]];
    const Vec2<double> q = room.floor.vertices[hull[(h + 1) % hull.size()]];
    const double length = Distance(p, q);
    const Vec2<double> normal{-(q.y - p.y) / length, (q.x - p.x) / length};
    half_planes_.push_back({normal, Dot(normal, p)});
  }
  AddPockets(room.floor, hull, areas_);
  outside_count_ = static_cast<int>(areas_.size());
  for (const Opening& opening : room.openings) {
    if (opening.kind != OpeningKind::kDoor) continue;
    for (Polygon& piece : ConvexSwingAreas(room, opening)) areas_.push_back(std::move(piece));
    if (passage_m > 0) areas_.push_back(PassageArea(room, opening, passage_m));
  }
}

Gap WidestGap(std::span<const Vec2<double>> a, std::span<const Vec2<double>> b) {
  Gap best{{1, 0}, -std::numeric_limits<double>::infinity()};
  TryNormals(a, b, 1, best);
  TryNormals(b, a, -1, best);
  return best;
}

bool IsSolid(const Object& object) { return object.kind == ObjectKind::kFloor && !object.walk_over; }

std::vector<Violation> FindViolations(const Scene& scene, const KeepOut& keep_out, std::span<const int> objects,
                                      const Layout& layout, double tolerance_m) {
  std::vector<Violation> found;
  for (size_t i = 0; i < objects.size(); ++i) {
    const int object = objects[i];
    if (!IsSolid(scene.objects[object])) continue;
    const auto corners = Corners(scene.objects[object].footprint, layout[object]);
    double outside = 0;
    for (const KeepOut::HalfPlane& plane : keep_out.half_planes()) {
      for (const Vec2<double>& corner : corners) outside = std::max(outside, plane.offset - Dot(plane.normal, corner));
    }
    if (outside > tolerance_m) found.push_back({object, -1, false, outside});
    for (size_t k = 0; k < keep_out.areas().size(); ++k) {
      const double depth = -WidestGap(keep_out.areas()[k].vertices, corners).gap_m;
      const bool at_door = static_cast<int>(k) >= keep_out.outside_count();
      if (depth > tolerance_m) found.push_back({object, -1, at_door, depth});
    }
    for (size_t j = 0; j < i; ++j) {
      if (!IsSolid(scene.objects[objects[j]])) continue;
      const double depth = -WidestGap(Corners(scene.objects[objects[j]].footprint, layout[objects[j]]), corners).gap_m;
      if (depth > tolerance_m) found.push_back({object, objects[j], false, depth});
    }
  }
  return found;
}

std::vector<LinearInequality> SeparationRows(const Scene& scene, const KeepOut& keep_out, std::span<const int> free,
                                             std::span<const int> fixed, const Layout& layout, double reach_m,
                                             double margin_m) {
  std::vector<LinearInequality> rows;
  // Dot(direction, moving - start) keeps `gap`, minus the other's movement when it moves too.
  const auto add = [&](int k, const Vec2<double>& direction, double gap, int other) {
    if (gap > reach_m) return;
    LinearInequality row;
    row.offset = margin_m - gap;
    const Vec2<double> start = Center(layout[free[k]]);
    row.Add(2 * k, -direction.x);
    row.Add(2 * k + 1, -direction.y);
    row.offset += Dot(direction, start);
    if (other >= 0) {
      const Vec2<double> other_start = Center(layout[free[other]]);
      row.Add(2 * other, direction.x);
      row.Add(2 * other + 1, direction.y);
      row.offset -= Dot(direction, other_start);
    }
    rows.push_back(row);
  };
  for (int k = 0; k < static_cast<int>(free.size()); ++k) {
    const int object = free[k];
    if (!IsSolid(scene.objects[object])) continue;
    const auto corners = Corners(scene.objects[object].footprint, layout[object]);
    for (const KeepOut::HalfPlane& plane : keep_out.half_planes()) {
      add(k, plane.normal, -SupportAlong(corners, -plane.normal) - plane.offset, -1);
    }
    for (const Polygon& area : keep_out.areas()) {
      const Gap gap = WidestGap(area.vertices, corners);
      add(k, gap.direction, gap.gap_m, -1);
    }
    for (int other : fixed) {
      if (!IsSolid(scene.objects[other])) continue;
      const Gap gap = WidestGap(Corners(scene.objects[other].footprint, layout[other]), corners);
      add(k, gap.direction, gap.gap_m, -1);
    }
    for (int j = 0; j < k; ++j) {
      if (!IsSolid(scene.objects[free[j]])) continue;
      const Gap gap = WidestGap(Corners(scene.objects[free[j]].footprint, layout[free[j]]), corners);
      add(k, gap.direction, gap.gap_m, j);
    }
  }
  return rows;
}

double ProjectOntoRows(std::span<const LinearInequality> rows, std::span<double> x, int max_rounds) {
  double worst = 0;
  for (int round = 0; round < max_rounds; ++round) {
    worst = 0;
    for (const LinearInequality& row : rows) {
      const double violation = row.Violation(x);
      worst = std::max(worst, violation);
      if (violation <= 0) continue;
      double squared = 0;
      for (int k = 0; k < row.count; ++k) squared += row.factors[k] * row.factors[k];
      // A little further than needed: without it the last millimetres take forever.
      const double step = 1.1 * violation / squared + 1e-9;
      for (int k = 0; k < row.count; ++k) x[row.variables[k]] -= step * row.factors[k];
    }
    if (worst <= 0) break;
  }
  return worst;
}

}  // namespace flair::optimizer
