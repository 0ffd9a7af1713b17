// SPDX-License-Identifier: GPL-3.0-or-later
// How far patterns stand in order.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "optimizer_worker/stages/patterns.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {
namespace {

// What it is worth that one of the groups of a pattern stands in order: about two missed constraints.
constexpr double kDisorder = 2;

// How exactly things have to stand to be in order.
struct Tolerance {
  double near_m;
  double turned_rad;
  // Turns of a full turn divided by this count as none.
  int axes;
};
// What a pattern is placed with, and what people see: beds along all four walls are no rows to them.
constexpr Tolerance kAsPlaced{1e-3, 1e-3, 4}, kAsSeen{0.1, 0.1, 2};

// Whether a group's objects stand to each other as in one of its arrangements.
bool IsArranged(const Group& group, const Layout& layout, const Tolerance& tolerance) {
  std::vector<Pose<double>> poses;
  return std::any_of(group.arrangements.begin(), group.arrangements.end(), [&](const Arrangement& arrangement) {
    PoseGroup(arrangement, layout[group.objects[0]], poses);
    for (size_t k = 1; k < poses.size(); ++k) {
      const Pose<double>& at = layout[group.objects[k]];
      if (Distance(Center(poses[k]), Center(at)) > tolerance.near_m ||
          AngleBetween(poses[k].theta_rad, at.theta_rad) > tolerance.turned_rad) {
        return false;
      }
    }
    return true;
  });
}

bool ArePlaced(const SolveInput& input, const std::vector<int>& groups, const PartialLayout& state) {
  return std::all_of(groups.begin(), groups.end(), [&](int g) {
    const std::vector<int>& objects = input.groups.all[g].objects;
    return std::all_of(objects.begin(), objects.end(), [&](int o) { return state.placed[o] != 0; });
  });
}

// Those of `groups`, all placed, that are arranged, look along the axes of most, and are in line with another.
std::vector<int> InOrder(const SolveInput& input, const std::vector<int>& groups, const Layout& layout,
                         const Tolerance& tolerance) {
  const std::vector<Group>& all = input.groups.all;
  const auto first = [&](int g) -> const Pose<double>& { return layout[all[g].objects[0]]; };
  const auto parallel = [&](int a, int b) {
    const double turn = WrapAngle(tolerance.axes * (first(a).theta_rad - first(b).theta_rad)) / tolerance.axes;
    return std::abs(turn) <= tolerance.turned_rad;
  };
  const auto companions = [&](int g) {
    return std::count_if(groups.begin(), groups.end(), [&](int other) { return parallel(g, other); });
  };
  const int model =
      *std::max_element(groups.begin(), groups.end(), [&](int a, int b) { return companions(a) < companions(b); });
  const Frame<double> frame = FrameOf(first(model));
  std::vector<int> in_order;
  std::copy_if(groups.begin(), groups.end(), std::back_inserter(in_order), [&](int g) {
    if (!parallel(g, model) || !IsArranged(all[g], layout, tolerance)) return false;
    return std::any_of(groups.begin(), groups.end(), [&](int other) {
      const Vec2<double> apart = frame.ToObject(Center(first(other))) - frame.ToObject(Center(first(g)));
      return other != g && (std::abs(apart.x) < tolerance.near_m || std::abs(apart.y) < tolerance.near_m);
    });
  });
  return in_order;
}

}  // namespace

double DisorderOf(const SolveInput& input, const std::vector<int>& groups, const Layout& layout) {
  return kDisorder * static_cast<double>(groups.size() - InOrder(input, groups, layout, kAsSeen).size());
}

double DisorderOf(const SolveInput& input, const PartialLayout& state) {
  double cost = 0;
  for (const std::vector<int>& pattern : input.groups.patterns) {
    if (ArePlaced(input, pattern, state)) cost += DisorderOf(input, pattern, state.layout);
  }
  return cost;
}

std::vector<int> InPattern(const SolveInput& input, const PartialLayout& state) {
  std::vector<int> held;
  for (const std::vector<int>& pattern : input.groups.patterns) {
    if (!ArePlaced(input, pattern, state)) continue;
    const std::vector<int> in_order = InOrder(input, pattern, state.layout, kAsPlaced);
    if (in_order.size() < (input.groups.all[pattern[0]].block ? 2 : kFewestAlike)) continue;
    for (int g : in_order) {
      const std::vector<int>& objects = input.groups.all[g].objects;
      held.insert(held.end(), objects.begin(), objects.end());
    }
  }
  std::sort(held.begin(), held.end());
  return held;
}

}  // namespace flair::optimizer
