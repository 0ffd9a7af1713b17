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

void HardCost::Prepare(std::span<const int> objects, const Problem& problem, const Layout& layout) {
  moving_.resize(objects.size());
  for (size_t k = 0; k < objects.size(); ++k) {
    Moving& moving = moving_[k];
    moving.object = objects[k];
    moving.reach_m = Reach(scene_.objects[objects[k]].footprint);
    moving.neighbours.clear();
    for (const auto& [other, weight] : weights_[objects[k]].others) {
      if (!problem.placed(other) || std::find(objects.begin(), objects.end(), other) != objects.end()) continue;
      const Footprint& footprint = scene_.objects[other].footprint;
      moving.neighbours.push_back(
          {Box<double>(footprint, FrameOf(layout[other])), Center(layout[other]), Reach(footprint), weight});
    }
  }
}

double HardCost::At(std::span<const Pose<double>> poses, double limit) const {
  double sum = 0;
  for (size_t k = 0; k < moving_.size() && sum <= limit; ++k) sum += One(moving_[k], poses[k], limit - sum);
  return sum;
}

double HardCost::One(const Moving& moving, const Pose<double>& pose, double limit) const {
  const Weights& weights = weights_[moving.object];
  const Vec2<double> center = Center(pose);
  const Box<double> box(scene_.objects[moving.object].footprint, FrameOf(pose));
  double sum = weights.bounds > 0 ? weights.bounds * keep_out_.floor().SquaredExcess(box) : 0.0;
  if (sum > limit) return sum;
  for (const Neighbour& neighbour : moving.neighbours) {
    if (Apart(center, neighbour.center, moving.reach_m + neighbour.reach_m)) continue;
    sum += neighbour.weight * SquaredPenetration<double>(box, neighbour.box);
    if (sum > limit) return sum;
  }
  if (weights.doors == 0) return sum;
  for (const Area& area : doors_) {
    if (Outside(area.box, center, moving.reach_m)) continue;
    sum += weights.doors * SquaredPenetration<double>(box, *area.piece);
  }
  return sum;
}

}  // namespace flair::optimizer
