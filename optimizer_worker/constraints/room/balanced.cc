// SPDX-License-Identifier: GPL-3.0-or-later
// Balances the room.
//   cost = | sum a_i p_i / sum a_i - c |^2                                                         [m2]
//   a_i, p_i  footprint area and centre of object i;  c  centre of the room (of its bounding box when a rectangle)
// [Paper] Eq. balanced, as released. Any number of objects: value and gradient are written out.
#include <algorithm>
#include <vector>

#include "optimizer_worker/constraints/cost.h"
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/whole_room.h"
#include "room/geometry/vec2.h"
#include "room/scene/scene.h"

namespace flair::optimizer {

namespace {

class BalancedCost final : public Cost {
 public:
  // `objects` ascending, each once, at least one.
  BalancedCost(const Scene& scene, std::vector<int> objects);

  std::span<const int> objects() const override { return objects_; }
  double ValueAt(std::span<const Frame<double>> frames) const override;
  double GradientAt(std::span<const Frame<double>> frames, std::span<double> gradient) const override;

 private:
  // Centre of mass minus centre of the room.
  Vec2<double> Offset(std::span<const Frame<double>> frames) const;

  std::vector<int> objects_;
  // a_i / sum a_i.
  std::vector<double> shares_;
  Vec2<double> room_center_;
};

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

}  // namespace

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
