// SPDX-License-Identifier: GPL-3.0-or-later
// The only file of the optimizer that sees CGAL: its headers take half a minute to compile.
#include "optimizer_worker/zones/voronoi_zones.h"

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace flair::optimizer {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_2;
using Line = Kernel::Line_2;
using ExactPolygon = CGAL::Polygon_2<Kernel>;
using ExactPolygonWithHoles = CGAL::Polygon_with_holes_2<Kernel>;

constexpr double kSmallestPart_m2 = 1e-10;
constexpr double kSmallestEdge_m = 1e-9;

ExactPolygon ToExact(const Polygon& polygon) {
  ExactPolygon exact;
  for (const Vec2<double>& p : polygon.vertices) exact.push_back(Point(p.x, p.y));
  return exact;
}

// A square that holds the floor with room to spare.
ExactPolygon Surroundings(const Polygon& floor) {
  double reach = 1;
  for (const Vec2<double>& p : floor.vertices) reach = std::max({reach, std::abs(p.x), std::abs(p.y)});
  reach *= 2;
  ExactPolygon square;
  square.push_back(Point(-reach, -reach));
  square.push_back(Point(reach, -reach));
  square.push_back(Point(reach, reach));
  square.push_back(Point(-reach, reach));
  return square;
}

// The part of a convex polygon on the positive side of a line.
ExactPolygon Clip(const ExactPolygon& convex, const Line& line) {
  ExactPolygon kept;
  for (size_t i = 0; i < convex.size(); ++i) {
    const Point& p = convex[i];
    const Point& q = convex[(i + 1) % convex.size()];
    const auto side_p = line.oriented_side(p);
    const auto side_q = line.oriented_side(q);
    if (side_p != CGAL::ON_NEGATIVE_SIDE) kept.push_back(p);
    if (side_p * side_q >= 0) continue;
    const auto crossing = CGAL::intersection(line, Line(p, q));
    if (const Point* point = boost::get<Point>(&*crossing)) kept.push_back(*point);
  }
  return kept;
}

ExactPolygon ConvexCell(const Polygon& floor, std::span<const Vec2<double>> sites, size_t own) {
  ExactPolygon cell = Surroundings(floor);
  const Point site(sites[own].x, sites[own].y);
  for (size_t other = 0; other < sites.size() && cell.size() >= 3; ++other) {
    if (other == own) continue;
    const Point rival(sites[other].x, sites[other].y);
    if (rival == site) {
      if (other < own) return ExactPolygon();
      continue;
    }
    Line bisector = CGAL::bisector(site, rival);
    if (bisector.has_on_negative_side(site)) bisector = bisector.opposite();
    cell = Clip(cell, bisector);
  }
  return cell;
}

Polygon ToPolygon(const ExactPolygon& exact) {
  Polygon polygon;
  for (auto it = exact.vertices_begin(); it != exact.vertices_end(); ++it) {
    const Vec2<double> p{CGAL::to_double(it->x()), CGAL::to_double(it->y())};
    const bool repeats = !polygon.vertices.empty() &&
                         std::hypot(p.x - polygon.vertices.back().x, p.y - polygon.vertices.back().y) < kSmallestEdge_m;
    if (!repeats) polygon.vertices.push_back(p);
  }
  return polygon;
}

}  // namespace

std::vector<ZoneCell> VoronoiZones(const Polygon& floor, std::span<const Vec2<double>> sites) {
  std::vector<ZoneCell> cells(sites.size());
  const ExactPolygon exact_floor = ToExact(floor);
  for (size_t i = 0; i < sites.size(); ++i) {
    const ExactPolygon cell = ConvexCell(floor, sites, i);
    if (cell.size() < 3 || cell.area() <= 0) continue;
    std::vector<ExactPolygonWithHoles> parts;
    CGAL::intersection(exact_floor, cell, std::back_inserter(parts));
    for (const ExactPolygonWithHoles& part : parts) {
      if (CGAL::to_double(part.outer_boundary().area()) < kSmallestPart_m2) continue;
      cells[i].push_back(ToPolygon(part.outer_boundary()));
    }
  }
  return cells;
}

}  // namespace flair::optimizer
