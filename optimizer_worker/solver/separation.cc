// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/solver/separation.h"

#include <algorithm>
#include <limits>

#include "optimizer_worker/constraints/whole_room.h"
#include "room/geometry/gap.h"

namespace flair::optimizer {
namespace {

Box<double> BoxOf(const Scene& scene, const Layout& layout, int object) {
  return Box<double>(scene.objects[object].footprint, FrameOf(layout[object]));
}

// Circles round the two do not meet.
bool FarApart(const Scene& scene, const Layout& layout, int a, int b) {
  const double reach =
      CircumscribedRadius(scene.objects[a].footprint) + CircumscribedRadius(scene.objects[b].footprint);
  return SquaredNorm(Center(layout[a]) - Center(layout[b])) > reach * reach;
}

double DepthBeyond(const FloorShape::HalfPlane& plane, const Box<double>& box) {
  double depth = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < 4; ++i) depth = std::max(depth, Dot(plane.normal, plane.point - box.value(i)));
  return depth;
}

template <typename A, typename B>
Separation SeparateShapes(const A& a, const B& b) {
  const Witness w = SeparatingAxis(a, b);
  if (w.kind == Witness::kEdgeOfFirst) return {a.normal(w.first), w.gap_m};
  return {-b.normal(w.second), w.gap_m};
}

}  // namespace

KeepOut::KeepOut(const Room& room) : floor_(room.floor), door_areas_(DoorAreas(room)) {}

Separation Separate(const Box<double>& a, const Box<double>& b) { return SeparateShapes(a, b); }

std::vector<Violation> FindViolations(const Scene& scene, const KeepOut& keep_out, std::span<const int> objects,
                                      const Layout& layout, double tolerance_m) {
  std::vector<Violation> found;
  std::vector<Box<double>> boxes;
  for (int object : objects) boxes.push_back(BoxOf(scene, layout, object));
  for (size_t i = 0; i < objects.size(); ++i) {
    const int object = objects[i];
    if (!IsSolid(scene.objects[object])) continue;
    const Box<double>& box = boxes[i];
    double outside = 0, at_door = 0;
    for (const FloorShape::HalfPlane& plane : keep_out.floor().half_planes()) {
      outside = std::max(outside, DepthBeyond(plane, box));
    }
    for (const ConvexPiece& pocket : keep_out.floor().pockets()) {
      outside = std::max(outside, -SeparateShapes(pocket, box).gap_m);
    }
    for (const ConvexPiece& area : keep_out.door_areas()) at_door = std::max(at_door, -SeparateShapes(area, box).gap_m);
    if (outside > tolerance_m) found.push_back({object, -1, false, outside});
    if (at_door > tolerance_m) found.push_back({object, -1, true, at_door});
    for (size_t j = 0; j < i; ++j) {
      if (FarApart(scene, layout, objects[j], object) || !CanCollide(scene, objects[j], object)) continue;
      const double depth = -Separate(boxes[j], box).gap_m;
      if (depth > tolerance_m) found.push_back({object, objects[j], false, depth});
    }
  }
  return found;
}

namespace {

// Collects rows: the box of variable pair k keeps its separation from something, or from the box of pair `other`.
class RowCollector {
 public:
  RowCollector(std::span<const int> free, const Layout& layout, double reach_m, double margin_m)
      : free_(free), layout_(layout), reach_m_(reach_m), margin_m_(margin_m) {}

  void Add(int k, const Separation& separation, int other = -1) {
    if (separation.gap_m > reach_m_) return;
    const Vec2<double>& n = separation.direction;
    LinearInequality row;
    row.offset = margin_m_ - separation.gap_m + Dot(n, Center(layout_[free_[k]]));
    row.Add(2 * k, -n.x);
    row.Add(2 * k + 1, -n.y);
    if (other >= 0) {
      row.offset -= Dot(n, Center(layout_[free_[other]]));
      row.Add(2 * other, n.x);
      row.Add(2 * other + 1, n.y);
    }
    rows.push_back(row);
  }

  std::vector<LinearInequality> rows;

 private:
  std::span<const int> free_;
  const Layout& layout_;
  double reach_m_, margin_m_;
};

}  // namespace

std::vector<LinearInequality> SeparationRows(const Scene& scene, const KeepOut& keep_out, std::span<const int> free,
                                             std::span<const int> fixed, const Layout& layout, double reach_m,
                                             double margin_m) {
  RowCollector collector(free, layout, reach_m, margin_m);
  for (int k = 0; k < static_cast<int>(free.size()); ++k) {
    if (!IsSolid(scene.objects[free[k]])) continue;
    const Box<double> box = BoxOf(scene, layout, free[k]);
    for (const FloorShape::HalfPlane& plane : keep_out.floor().half_planes()) {
      collector.Add(k, {plane.normal, -DepthBeyond(plane, box)});
    }
    for (const ConvexPiece& pocket : keep_out.floor().pockets()) collector.Add(k, SeparateShapes(pocket, box));
    for (const ConvexPiece& area : keep_out.door_areas()) collector.Add(k, SeparateShapes(area, box));
    for (int other : fixed) {
      if (CanCollide(scene, other, free[k])) collector.Add(k, Separate(BoxOf(scene, layout, other), box));
    }
    for (int j = 0; j < k; ++j) {
      if (CanCollide(scene, free[j], free[k])) collector.Add(k, Separate(BoxOf(scene, layout, free[j]), box), j);
    }
  }
  return std::move(collector.rows);
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
