// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluation/metrics/pathway.h"

#include <algorithm>
#include <cmath>

#include "evaluation/metrics/ways.h"
#include "room/geometry/footprint.h"

namespace flair::evaluation {
namespace {

constexpr double kStep_m = 0.1;
constexpr int kSteps = 3;

// How deep a point is inside an object; 0 outside.
double DepthIn(const Footprint& footprint, const Frame<double>& frame, const Vec2<double>& p) {
  const Vec2<double> local = frame.ToObject(p);
  return std::max(0.0, std::min(footprint.width_m / 2 - std::abs(local.x), footprint.depth_m / 2 - std::abs(local.y)));
}

}  // namespace

double PathwayCost_m3(const LayoutView& view) {
  std::vector<std::pair<Footprint, Frame<double>>> solids;
  for (size_t i = 0; i < view.scene.objects.size(); ++i) {
    if (!view.Has(i) || !IsSolid(view.scene.objects[i])) continue;
    solids.emplace_back(view.scene.objects[i].footprint, FrameOf(view.layout[i]));
  }
  double cost = 0;
  for (const WayPiece& piece : FindWays(view)) {
    if (piece.half_width_m >= kSteps * kStep_m) continue;
    double section = 0;
    for (int k = -kSteps; k <= kSteps; ++k) {
      const Vec2<double> p = piece.middle + (k * kStep_m) * piece.across;
      const double weight = 1 + kSteps - std::abs(k);
      for (const auto& [footprint, frame] : solids) {
        const double depth = DepthIn(footprint, frame, p);
        section += weight * depth * depth;
      }
    }
    cost += piece.weighted_length_m * section;
  }
  return cost;
}

}  // namespace flair::evaluation
