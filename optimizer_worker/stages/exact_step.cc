// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/exact_step.h"

#include <algorithm>
#include <cmath>

#include "room/geometry/pose.h"

namespace flair::optimizer {
namespace {

constexpr int kRounds = 4;
constexpr double kReach_m = 0.6;
constexpr double kLargestMove_m = 0.2;
// Kept between objects: above the solver's feasibility tolerance, below anything that counts.
constexpr double kMargin_m = 5e-8;
constexpr int kProjectionRounds = 300;
// Rows times variables. A room of 40 pieces has a third of it; with more, one step of SLSQP takes seconds that no stop
// can end, and the nearest point that keeps the rows is taken without asking for its cost.
constexpr size_t kLargestProgram = 150000;
// The same when time is up; a room of 25 pieces has about half of it.
constexpr size_t kLargestInHaste = 20000;

Bounds MakeBounds(std::span<const double> x, std::vector<LinearInequality> rows) {
  Bounds bounds;
  for (double value : x) {
    bounds.lower.push_back(value - kLargestMove_m);
    bounds.upper.push_back(value + kLargestMove_m);
  }
  bounds.inequalities = std::move(rows);
  return bounds;
}

double WorstOf(const std::vector<Violation>& violations) {
  double worst = 0;
  for (const Violation& violation : violations) worst = std::max(worst, violation.depth_m);
  return worst;
}

}  // namespace

void SnapHeadings(const Scene& scene, std::span<const int> objects, Layout& layout) {
  for (int object : objects) {
    double& theta = layout[object].theta_rad;
    double best = kSnap_rad;
    double snapped = theta;
    for (const Wall& wall : scene.room.walls) {
      const double off = theta - wall.BackHeading();
      const double turn = off - std::round(off / (kPi / 2)) * (kPi / 2);
      if (std::abs(turn) >= best) continue;
      best = std::abs(turn);
      snapped = wall.BackHeading() + std::round(off / (kPi / 2)) * (kPi / 2);
    }
    theta = WrapHeading(snapped);
  }
}

std::vector<Violation> MakeExact(const SolveInput& input, Problem& problem, std::span<const int> free, Layout& layout) {
  std::vector<int> moving, standing, all;
  for (int i = 0; i < static_cast<int>(input.scene.objects.size()); ++i) {
    if (!problem.placed(i) || !IsSolid(input.scene.objects[i])) continue;
    (std::find(free.begin(), free.end(), i) != free.end() ? moving : standing).push_back(i);
    all.push_back(i);
  }
  SnapHeadings(input.scene, moving, layout);
  std::vector<Violation> left = FindViolations(input.scene, input.keep_out, all, layout, kTouching_m);
  const SolverLimits limits{
      .max_evaluations = 40, .relative_tolerance = 1e-4, .absolute_tolerance = 1e-6, .stop = &input.cancelled};
  // Exact even when time is up; not when nobody waits.
  for (int round = 0; round < kRounds && !input.Cancelled(); ++round) {
    ProblemObjective objective(problem, layout, moving, false);
    std::vector<double> x = objective.Start();
    const std::vector<LinearInequality> rows =
        SeparationRows(input.scene, input.keep_out, moving, standing, layout, kReach_m, kMargin_m);
    const double unprojected = ProjectOntoRows(rows, x, kProjectionRounds);
    const std::vector<double> projected = x;
    if (rows.size() * x.size() > (input.OutOfTime() ? kLargestInHaste : kLargestProgram)) {
      objective.Apply(projected);
    } else {
      const SolverReport report = input.solver.Minimize(objective, MakeBounds(x, rows), limits, x);
      objective.Apply(report.violation <= std::max(kMargin_m, unprojected) ? x : projected);
    }
    left = FindViolations(input.scene, input.keep_out, all, layout, kTouching_m);
    if (WorstOf(left) <= kTouching_m) break;
  }
  std::stable_sort(left.begin(), left.end(),
                   [](const Violation& a, const Violation& b) { return a.depth_m > b.depth_m; });
  return left;
}

}  // namespace flair::optimizer
