// SPDX-License-Identifier: GPL-3.0-or-later
// Stands objects side by side.
//   cost = sum over neighbours (a left of b) of  out(gap, [0, 0.05])^2 + offset^2 + (1 - cos(theta_a - theta_b)) [m2]
//   gap     air between the right side of a and the left side of b;  offset  of b's back from the line of a's back
// Neighbours are next to each other in order along the first object's right, wherever they stand in the list. Zero
// exactly when they form one row with flush backs and the same heading.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "optimizer_worker/autodiff/smooth.h"
#include "optimizer_worker/constraints/cost.h"
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "room/scene/scene.h"

namespace flair::optimizer {

namespace {

class RowCost final : public Cost {
 public:
  static constexpr int kMaxObjects = 16;

  // Two to kMaxObjects objects.
  RowCost(const Scene& scene, const std::vector<int>& objects);

  std::span<const int> objects() const override { return objects_; }
  double ValueAt(std::span<const Frame<double>> frames) const override;
  double GradientAt(std::span<const Frame<double>> frames, std::span<double> gradient) const override;

 private:
  // Positions in objects_, from left to right.
  std::array<size_t, kMaxObjects> Order(std::span<const Frame<double>> frames) const;
  template <typename T>
  T NeighbourCost(const Footprint& left, const Frame<T>& left_frame, const Footprint& right,
                  const Frame<T>& right_frame) const;

  std::vector<int> objects_;
  std::vector<Footprint> footprints_;
};

RowCost::RowCost(const Scene& scene, const std::vector<int>& objects) : objects_(objects) {
  std::sort(objects_.begin(), objects_.end());
  for (int i : objects_) footprints_.push_back(scene.objects[static_cast<size_t>(i)].footprint);
}

std::array<size_t, RowCost::kMaxObjects> RowCost::Order(std::span<const Frame<double>> frames) const {
  std::array<size_t, kMaxObjects> order{};
  std::array<double, kMaxObjects> place{};
  const Vec2<double> right = frames[0].right;
  for (size_t i = 0; i < frames.size(); ++i) {
    order[i] = i;
    place[i] = Dot(right, frames[i].center);
  }
  std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(frames.size()),
            [&place](size_t a, size_t b) { return place[a] != place[b] ? place[a] < place[b] : a < b; });
  return order;
}

template <typename T>
T RowCost::NeighbourCost(const Footprint& left, const Frame<T>& left_frame, const Footprint& right,
                         const Frame<T>& right_frame) const {
  constexpr double kAir_m = 0.05;
  const Vec2<T> p = left_frame.ToObject(right_frame.center);
  const T gap = p.x - (left.width_m + right.width_m) / 2;
  const T offset = p.y - (right.depth_m - left.depth_m) / 2;
  return SquaredOutside(gap, 0, kAir_m) + Square(offset) + Turn(left_frame.front, right_frame.front);
}

double RowCost::ValueAt(std::span<const Frame<double>> frames) const {
  const auto order = Order(frames);
  double sum = 0;
  for (size_t k = 0; k + 1 < frames.size(); ++k) {
    sum += NeighbourCost(footprints_[order[k]], frames[order[k]], footprints_[order[k + 1]], frames[order[k + 1]]);
  }
  return sum;
}

double RowCost::GradientAt(std::span<const Frame<double>> frames, std::span<double> gradient) const {
  std::fill(gradient.begin(), gradient.end(), 0.0);
  const auto order = Order(frames);
  double sum = 0;
  for (size_t k = 0; k + 1 < frames.size(); ++k) {
    const size_t left = order[k], right = order[k + 1];
    sum += AddPair(frames, left, right, gradient, [this, left, right](const auto& a, const auto& b) {
      return NeighbourCost(footprints_[left], a, footprints_[right], b);
    });
  }
  return sum;
}

std::optional<Shortfall> RowShortfall(const PlacedCall& call) {
  const std::vector<int>& objects = call.arguments().Objects("objects");
  return Worst(
      {OffBy(fmt::format("one of {} and its neighbours", call.Name(objects[0])), "one flush row", call.CostRoot())});
}

}  // namespace

ConstraintFacts RowFacts() {
  return {.name = "row",
          .family = "group",
          .summary = "`objects` stand side by side in one row, backs flush, facing the same way.",
          .phrase = "stands in one row with its like: {objects}",
          .doc =
              "cost = sum over neighbours of squared gap beyond [0, 0.05 m] + squared offset of the backs + (1 - cos "
              "of the "
              "difference of headings) [m2].",
          .parameters = {ObjectsParameter("objects", "What forms the row; any order.")},
          .sentences = {{"The kitchen cabinets stand in a row.", "objects=cabinet_1,cabinet_2,cabinet_3"}},
          .layouts = {Satisfied("5x4 room; a 1x0.6 at 1,0.3,0; b 0.6x0.4 at 2.64,0.2,0; c 0.8x0.6 at 1.92,0.3,0",
                                "objects=a,b,c"),
                      Violated("5x4 room; a 1x0.6 at 1,0.3,0; b 0.6x0.4 at 2.9,0.4,10; c 0.8x0.6 at 1.92,0.3,0",
                               "objects=a,b,c")},
          .shortfall = RowShortfall,
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            const std::vector<int>& objects = a.Objects("objects");
            if (objects.size() < 2 || objects.size() > static_cast<size_t>(RowCost::kMaxObjects)) {
              return absl::InvalidArgumentError(fmt::format("argument objects: {} cannot form a row; give 2 to {}",
                                                            objects.size(), RowCost::kMaxObjects));
            }
            return std::make_unique<RowCost>(context.scene, objects);
          }};
}

}  // namespace flair::optimizer
