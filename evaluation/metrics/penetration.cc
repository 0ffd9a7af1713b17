// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluation/metrics/penetration.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "room/geometry/footprint.h"
#include "room/geometry/polygon.h"
#include "room/scene/room.h"

namespace flair::evaluation {
namespace {

constexpr int kDoorArcPieces = 32;

// Widest gap between two convex shapes along the outward normals of `a`; negative when none parts them.
double WidestGap(std::span<const Vec2<double>> a, std::span<const Vec2<double>> b) {
  double widest = -std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < a.size(); ++i) {
    const Vec2<double> edge = a[(i + 1) % a.size()] - a[i];
    const double length = Norm(edge);
    if (length == 0) continue;
    const Vec2<double> normal = (-1 / length) * Perpendicular(edge);
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec2<double>& p : b) nearest = std::min(nearest, Dot(normal, p - a[i]));
    widest = std::max(widest, nearest);
  }
  return widest;
}

double Penetration_m(std::span<const Vec2<double>> a, std::span<const Vec2<double>> b) {
  return std::max(0.0, -std::max(WidestGap(a, b), WidestGap(b, a)));
}

}  // namespace

double DeepestOverlap_m(const LayoutView& view) {
  const Scene& scene = view.scene;
  double deepest = 0;
  std::vector<std::array<Vec2<double>, 4>> solids;
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    if (!view.Has(i)) continue;
    const std::array<Vec2<double>, 4> corners = Corners(scene.objects[i].footprint, view.layout[i]);
    for (const Vec2<double>& corner : corners) {
      deepest = std::max(deepest, -SignedDistance(scene.room.floor, corner));
    }
    if (!IsSolid(scene.objects[i])) continue;
    for (const auto& other : solids) deepest = std::max(deepest, Penetration_m(corners, other));
    solids.push_back(corners);
  }
  for (const Opening& door : scene.room.openings) {
    for (const Polygon& piece : ConvexSwingAreas(scene.room, door, kDoorArcPieces)) {
      for (const auto& corners : solids) deepest = std::max(deepest, Penetration_m(corners, piece.vertices));
    }
  }
  return deepest;
}

}  // namespace flair::evaluation
