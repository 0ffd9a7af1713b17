// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/solver/hard_cost.h"

#include <algorithm>
#include <cmath>

#include "optimizer_worker/constraints/whole_room.h"
#include "room/geometry/gap.h"

namespace flair::optimizer {
namespace {

double Reach(const Footprint& footprint) {
  return std::sqrt(footprint.width_m * footprint.width_m + footprint.depth_m * footprint.depth_m) / 2;
}

bool Apart(const Vec2<double>& a, const Vec2<double>& b, double reach) { return SquaredNorm(a - b) >= reach * reach; }

bool Outside(const BoundingBox& box, const Vec2<double>& p, double reach) {
  return p.x < box.min.x - reach || p.x > box.max.x + reach || p.y < box.min.y - reach || p.y > box.max.y + reach;
}

}  // namespace

HardCost::HardCost(const Scene& scene, const KeepOut& keep_out, const Problem& problem)
    : scene_(scene), keep_out_(keep_out), weights_(scene.objects.size()) {
  for (int t : problem.active()) {
    const Term& term = problem.terms()[t];
    if (!term.hard) continue;
    const int first = term.required.front();
    if (term.name == kInBoundsTerm) weights_[first].bounds = term.weight;
    if (term.name == kDoorClearTerm) weights_[first].doors = term.weight;
    if (term.name != kNoOverlapTerm) continue;
    weights_[first].others.emplace_back(term.required.back(), term.weight);
    weights_[term.required.back()].others.emplace_back(first, term.weight);
  }
  // The areas reach far behind their walls; what counts is where they reach into the room.
  const BoundingBox room = BoundsOf(scene.room.floor);
  for (const ConvexPiece& piece : keep_out.door_areas()) {
    Area area{&piece, {room.max, room.min}};
    for (const Vec2<double>& v : piece.vertices) {
      const Vec2<double> p{std::clamp(v.x, room.min.x, room.max.x), std::clamp(v.y, room.min.y, room.max.y)};
      area.box.min = {std::min(area.box.min.x, p.x), std::min(area.box.min.y, p.y)};
      area.box.max = {std::max(area.box.max.x, p.x), std::max(area.box.max.y, p.y)};
    }
    doors_.push_back(area);
  }
}

void HardCost::Prepare(int object, const Problem& problem, const Layout& layout) {
  object_ = object;
  reach_m_ = Reach(scene_.objects[object].footprint);
  neighbours_.clear();
  for (const auto& [other, weight] : weights_[object].others) {
    if (!problem.placed(other)) continue;
    const Footprint& footprint = scene_.objects[other].footprint;
    neighbours_.push_back(
        {Box<double>(footprint, FrameOf(layout[other])), Center(layout[other]), Reach(footprint), weight});
  }
}

double HardCost::At(const Pose<double>& pose, double limit) const {
  const Weights& weights = weights_[object_];
  const Vec2<double> center = Center(pose);
  const Box<double> box(scene_.objects[object_].footprint, FrameOf(pose));
  double sum = weights.bounds > 0 ? weights.bounds * keep_out_.floor().SquaredExcess(box) : 0.0;
  if (sum > limit) return sum;
  for (const Neighbour& neighbour : neighbours_) {
    if (Apart(center, neighbour.center, reach_m_ + neighbour.reach_m)) continue;
    sum += neighbour.weight * SquaredPenetration<double>(box, neighbour.box);
    if (sum > limit) return sum;
  }
  if (weights.doors == 0) return sum;
  for (const Area& area : doors_) {
    if (Outside(area.box, center, reach_m_)) continue;
    sum += weights.doors * SquaredPenetration<double>(box, *area.piece);
  }
  return sum;
}

}  // namespace flair::optimizer
