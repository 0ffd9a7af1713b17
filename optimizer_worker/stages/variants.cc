// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/variants.h"

#include <algorithm>
#include <numeric>

#include "optimizer_worker/stages/pins.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {
namespace {

constexpr double kMoved_m = 0.5;
constexpr double kTurned_rad = kPi / 6;

}  // namespace

std::vector<int> LeadingObjects(const SolveInput& input) {
  std::vector<int> leading = FreeStage(input, StageKind::kPrimary).objects;
  if (!leading.empty()) return leading;
  leading = FreeStage(input, StageKind::kPolish).objects;
  std::erase_if(leading, [&](int object) { return input.scene.objects[object].role == ObjectRole::kTertiary; });
  return leading;
}

bool DifferVisibly(std::span<const int> objects, const Layout& a, const Layout& b) {
  return std::any_of(objects.begin(), objects.end(), [&](int object) {
    return Distance(Center(a[object]), Center(b[object])) > kMoved_m ||
           AngleBetween(a[object].theta_rad, b[object].theta_rad) > kTurned_rad;
  });
}

std::vector<size_t> BestDistinct(size_t count, size_t most, const std::function<double(size_t)>& score,
                                 const std::function<bool(size_t, size_t)>& differ) {
  std::vector<size_t> order(count);
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return score(a) < score(b); });
  std::vector<size_t> kept;
  for (size_t i : order) {
    if (kept.size() == most) break;
    if (std::all_of(kept.begin(), kept.end(), [&](size_t k) { return differ(i, k); })) kept.push_back(i);
  }
  return kept;
}

}  // namespace flair::optimizer
