// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/room/balanced.h"

#include <algorithm>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/whole_room.h"

namespace flair::optimizer {

BalancedCost::BalancedCost(const Scene& scene, std::vector<int> objects)
    : objects_(std::move(objects)), room_center_(Centroid(scene.room.floor)) {
  double total = 0;
  for (int i : objects_) total += scene.objects[static_cast<size_t>(i)].footprint.area_m2();
  for (int i : objects_) shares_.push_back(scene.objects[static_cast<size_t>(i)].footprint.area_m2() / total);
}

Vec2<double> BalancedCost::Offset(std::span<const Frame<double>> frames) const {
  Vec2<double> offset = -room_center_;
  for (size_t i = 0; i < shares_.size(); ++i) offset += shares_[i] * frames[i].center;
  return offset;
}

double BalancedCost::ValueAt(std::span<const Frame<double>> frames) const { return SquaredNorm(Offset(frames)); }

double BalancedCost::GradientAt(std::span<const Frame<double>> frames, std::span<double> gradient) const {
  const Vec2<double> offset = Offset(frames);
  for (size_t i = 0; i < shares_.size(); ++i) {
    gradient[3 * i] = 2 * shares_[i] * offset.x;
    gradient[3 * i + 1] = 2 * shares_[i] * offset.y;
    gradient[3 * i + 2] = 0;
  }
  return SquaredNorm(offset);
}

std::unique_ptr<Cost> Balanced(const Scene& scene, std::span<const int> objects) {
  if (objects.empty()) return nullptr;
  std::vector<int> sorted(objects.begin(), objects.end());
  std::sort(sorted.begin(), sorted.end());
  return std::make_unique<BalancedCost>(scene, std::move(sorted));
}

ConstraintFacts BalancedFacts() {
  return {.name = "balanced",
          .family = "room",
          .summary = "The centre of mass of `objects` is the centre of the room.",
          .doc =
              "cost = squared distance of the footprint-weighted mean of the centres to the room's centre [m2]. The "
              "paper's "
              "balance term, as released.",
          .parameters = {ObjectsParameter("objects", "What is balanced.")},
          .layouts = {Satisfied("4x3 room; a 1x1 at 1,1.5,0; b 1x1 at 3,1.5,40", "objects=a,b"),
                      Violated("4x3 room; a 1x1 at 1,1.5,0; b 1x2 at 3,1.5,40", "objects=a,b")},
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            return Balanced(context.scene, a.Objects("objects"));
          },
          .built_in = true};
}

}  // namespace flair::optimizer
