// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/hilbert_sort.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "evaluation/metrics/measures.h"
#include "room/geometry/polygon.h"

namespace flair::evaluation {
namespace {

constexpr double kStep_m = 0.1;
constexpr int kSteps = 3;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel>;
using Point = Kernel::Point_2;

// Less than a slit, or neighbouring samples would be one.
constexpr double kSpacing_m = 0.018;
constexpr double kPiece_m = 0.05;
// sin^2 of half the angle at which the two places are seen: 104 and 143 degrees. A corner of 90 degrees, sampled, stays
// below.
constexpr double kCorner = 0.62, kOpposite = 0.9;
constexpr double kSlit_m = 0.02, kGap_m = 0.04, kRounding_m = 1e-9;

// Linear from 0 at `low` to 1 at `high`.
double Ramp(double value, double low, double high) { return std::clamp((value - low) / (high - low), 0.0, 1.0); }

// Both ends, and points in between at even steps.
void SampleSegment(const Vec2<double>& from, const Vec2<double>& to, std::vector<Point>& samples) {
  const int steps = std::max(1, static_cast<int>(std::ceil(Distance(from, to) / kSpacing_m)));
  for (int i = 0; i <= steps; ++i) {
    const Vec2<double> p = from + (static_cast<double>(i) / steps) * (to - from);
    samples.emplace_back(p.x, p.y);
  }
}

// A wall as the parts between its doors.
void SampleWall(const Room& room, int index, std::vector<Point>& samples) {
  const Wall& wall = room.walls[static_cast<size_t>(index)];
  std::vector<std::pair<double, double>> doors;
  for (const Opening& opening : room.openings) {
    if (opening.kind != OpeningKind::kDoor || opening.wall != index) continue;
    doors.emplace_back(std::max(0.0, opening.offset_m), std::min(wall.length_m, opening.offset_m + opening.width_m));
  }
  std::ranges::sort(doors);
  double from = 0;
  for (const auto& [low, high] : doors) {
    if (low > from) SampleSegment(wall.PointAt(from), wall.PointAt(low), samples);
    from = std::max(from, high);
  }
  if (from < wall.length_m) SampleSegment(wall.PointAt(from), wall.PointAt(wall.length_m), samples);
}

struct Solid {
  Frame<double> frame;
  Footprint footprint;

  // How deep a point is inside; 0 outside.
  double DepthOf(const Vec2<double>& p) const {
    const Vec2<double> local = frame.ToObject(p);
    return std::max(0.0,
                    std::min(footprint.width_m / 2 - std::abs(local.x), footprint.depth_m / 2 - std::abs(local.y)));
  }
};

std::vector<Solid> SolidsOf(const LayoutView& view) {
  std::vector<Solid> solids;
  for (size_t i = 0; i < view.scene.objects.size(); ++i) {
    if (!view.Has(i) || !IsSolid(view.scene.objects[i])) continue;
    solids.push_back({FrameOf(view.layout[i]), view.scene.objects[i].footprint});
  }
  return solids;
}

std::vector<Point> SampleBoundary(const LayoutView& view, const std::vector<Solid>& solids) {
  std::vector<Point> samples;
  for (int i = 0; i < static_cast<int>(view.scene.room.walls.size()); ++i) SampleWall(view.scene.room, i, samples);
  for (const Solid& solid : solids) {
    const std::array<Vec2<double>, 4> corners = Corners(solid.footprint, solid.frame);
    for (size_t k = 0; k < 4; ++k) SampleSegment(corners[k], corners[(k + 1) % 4], samples);
  }
  return samples;
}

// Walks along a ridge between the cells of `a` and `b` and adds the pieces that are on free floor.
void AddRidge(const Vec2<double>& from, const Vec2<double>& to, const Vec2<double>& a, const Vec2<double>& b,
              const Polygon& floor, const std::vector<Solid>& solids, std::vector<WayPiece>& pieces) {
  const double width = Distance(a, b);
  const double slit = Ramp(width, kSlit_m, kGap_m);
  const double length = Distance(from, to);
  if (length == 0) return;
  const int steps = static_cast<int>(std::ceil(length / kPiece_m));
  for (int i = 0; i < steps; ++i) {
    const Vec2<double> p = from + ((i + 0.5) / steps) * (to - from);
    const double radius = Distance(p, a);
    const double opposite = Ramp(width * width / (4 * radius * radius), kCorner, kOpposite);
    if (opposite == 0 || !Contains(floor, p)) continue;
    if (std::ranges::any_of(solids, [&p](const Solid& solid) { return solid.DepthOf(p) > 0; })) continue;
    pieces.push_back({p, (1 / width) * (b - a), slit * opposite * length / steps, radius});
  }
}

// The vertex across the edge `index` of the triangle on that side of it which is finite.
Vec2<double> ThirdVertex(const Delaunay& delaunay, Delaunay::Face_handle face, int index,
                         Delaunay::Face_handle neighbour) {
  const Point& p =
      delaunay.is_infinite(face) ? neighbour->vertex(neighbour->index(face))->point() : face->vertex(index)->point();
  return {p.x(), p.y()};
}

// The finite edges, each seen from the triangle in which its lesser end comes first.
std::vector<Delaunay::Edge> EdgesInOrder(const Delaunay& delaunay) {
  std::vector<Delaunay::Edge> edges;
  for (auto face = delaunay.all_faces_begin(); face != delaunay.all_faces_end(); ++face) {
    for (int index = 0; index < 3; ++index) {
      const auto a = face->vertex(Delaunay::cw(index)), b = face->vertex(Delaunay::ccw(index));
      if (delaunay.is_infinite(a) || delaunay.is_infinite(b) || !(a->point() < b->point())) continue;
      edges.emplace_back(face, index);
    }
  }
  return edges;
}

}  // namespace

double PathwayCost_m3(const LayoutView& view) {
  constexpr double kReach_m = kSteps * kStep_m;
  const std::vector<Solid> solids = SolidsOf(view);
  double cost = 0;
  for (const WayPiece& piece : FindWays(view, 2 * kReach_m)) {
    if (piece.half_width_m >= kReach_m) continue;
    double section = 0;
    for (int k = -kSteps; k <= kSteps; ++k) {
      const Vec2<double> p = piece.middle + (k * kStep_m) * piece.across;
      const double weight = 1 + kSteps - std::abs(k);
      for (const Solid& solid : solids) {
        const double depth = solid.DepthOf(p);
        section += weight * depth * depth;
      }
    }
    cost += piece.weighted_length_m * section;
  }
  return cost;
}

std::vector<WayPiece> FindWays(const LayoutView& view, double widest_m) {
  const std::vector<Solid> solids = SolidsOf(view);
  std::vector<Point> samples = SampleBoundary(view, solids);
  // In the order of a Hilbert curve, one after the other: inserting a range shuffles it by a generator that all of the
  // process shares, and the sum of the pieces would differ in its last bits from call to call. On the curve the last
  // sample is a good hint for the next one, and no long thin triangles are flipped again and again.
  CGAL::hilbert_sort(samples.begin(), samples.end());
  Delaunay delaunay;
  Delaunay::Face_handle hint;
  for (const Point& sample : samples) hint = delaunay.insert(sample, hint)->face();
  std::vector<WayPiece> pieces;
  // CGAL's own list of edges takes each from the triangle of lower address, which differs from call to call.
  for (const auto& [face, index] : EdgesInOrder(delaunay)) {
    const auto neighbour = face->neighbor(index);
    const Point& a = face->vertex(Delaunay::cw(index))->point();
    const Point& b = face->vertex(Delaunay::ccw(index))->point();
    // The ridge counts only where its two places are opposite: within a circle round their middle.
    const Vec2<double> pa{a.x(), a.y()}, pb{b.x(), b.y()}, middle = 0.5 * (pa + pb);
    const double width = Distance(pa, pb), reach = width / 2;
    if (width <= kSlit_m || width > widest_m + kRounding_m) continue;
    const Vec2<double> along = Perpendicular((1 / width) * (pb - pa));
    // Where the ridge ends beside a triangle; on the hull (in a door, say) it goes on and on to the other side.
    const auto end = [&](const auto& cell, double beyond) {
      if (delaunay.is_infinite(cell)) return beyond;
      const Point center = delaunay.dual(cell);
      const double at = Dot(Vec2<double>{center.x(), center.y()} - middle, along);
      // A triangle that is flat but for rounding has its centre nowhere.
      return std::isfinite(at) ? at : beyond;
    };
    const bool ahead = Dot(along, ThirdVertex(delaunay, face, index, neighbour) - middle) > 0;
    const double one = std::clamp(end(face, ahead ? -reach : reach), -reach, reach);
    const double other = std::clamp(end(neighbour, ahead ? -reach : reach), -reach, reach);
    if (one == other) continue;
    AddRidge(middle + std::min(one, other) * along, middle + std::max(one, other) * along, pa, pb,
             view.scene.room.floor, solids, pieces);
  }
  return pieces;
}

}  // namespace flair::evaluation
