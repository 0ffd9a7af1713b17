// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/solver/crowding.h"

#include <algorithm>
#include <cmath>

namespace flair::optimizer {
namespace {

constexpr double kTouching_m = 0.02, kNarrow_m = 0.6;
// sin of the largest angle that passes for parallel.
constexpr double kParallel = 0.05;

double Square(double x) { return x * x; }

// F for one side that is furniture.
double CrossSection_m2(double gap_m) {
  double sum = 0;
  for (int k = 1; k <= 3; ++k) sum += (4 - k) * Square(std::max(0.0, 0.1 * k - gap_m / 2));
  return sum;
}

double Overlap(double low_a, double high_a, double low_b, double high_b) {
  return std::min(high_a, high_b) - std::max(low_a, low_b);
}

// `length_m` may be negative: then the two are not opposite each other.
double GapCost(double gap_m, double length_m) {
  if (length_m <= 0 || gap_m <= kTouching_m || gap_m >= kNarrow_m) return 0;
  return length_m * CrossSection_m2(gap_m);
}

struct Placed {
  Frame<double> frame;
  double half_width_m, half_depth_m, reach_m;
};

double PairCost(const Placed& a, const Placed& b) {
  const double reach = a.reach_m + b.reach_m + kNarrow_m;
  if (SquaredNorm(a.frame.center - b.frame.center) >= reach * reach) return 0;
  const double c = Dot(a.frame.right, b.frame.right), s = Dot(a.frame.front, b.frame.right);
  if (std::abs(c * s) > kParallel) return 0;
  const bool turned = std::abs(s) > 0.5;
  const double u = turned ? b.half_depth_m : b.half_width_m, v = turned ? b.half_width_m : b.half_depth_m;
  const Vec2<double> p = a.frame.ToObject(b.frame.center);
  const double gap_u = std::abs(p.x) - a.half_width_m - u, gap_v = std::abs(p.y) - a.half_depth_m - v;
  return 2 * (GapCost(gap_u, Overlap(-a.half_depth_m, a.half_depth_m, p.y - v, p.y + v)) +
              GapCost(gap_v, Overlap(-a.half_width_m, a.half_width_m, p.x - u, p.x + u)));
}

double WallCost(const Placed& a, const Wall& wall) {
  const double height = wall.Height(a.frame.center), offset = wall.Offset(a.frame.center);
  if (height >= a.reach_m + kNarrow_m) return 0;
  const double c = Dot(a.frame.front, wall.inward_normal), s = Dot(a.frame.right, wall.inward_normal);
  if (std::abs(c * s) > kParallel) return 0;
  const bool turned = std::abs(s) > 0.5;
  const double half_length = turned ? a.half_depth_m : a.half_width_m;
  return GapCost(height - (turned ? a.half_width_m : a.half_depth_m),
                 Overlap(0, wall.length_m, offset - half_length, offset + half_length));
}

}  // namespace

double CrowdingCost_m3(const Room& room, std::span<const Obstacle> obstacles) {
  double sum = 0;
  // Rooms hold tens of obstacles; more are cut off rather than allocated for.
  constexpr size_t kMost = 128;
  Placed placed[kMost];
  const size_t count = std::min(kMost, obstacles.size());
  for (size_t i = 0; i < count; ++i) {
    const Footprint& footprint = obstacles[i].footprint;
    placed[i] = {FrameOf(obstacles[i].pose), footprint.width_m / 2, footprint.depth_m / 2,
                 CircumscribedRadius(footprint)};
    for (size_t k = 0; k < i; ++k) sum += PairCost(placed[i], placed[k]);
    for (const Wall& wall : room.walls) sum += WallCost(placed[i], wall);
  }
  return sum;
}

}  // namespace flair::optimizer
