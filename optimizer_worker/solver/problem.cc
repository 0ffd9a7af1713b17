// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/solver/problem.h"

#include <algorithm>

namespace flair::optimizer {

Pose<double> FarAway(int object) { return {1e4 + 100.0 * object, 1e4, 0}; }

Problem::Problem(std::span<const Term> terms, std::vector<int> active, int object_count)
    : terms_(terms),
      active_(std::move(active)),
      touching_(object_count),
      hard_touching_(object_count, 0),
      requiring_(object_count),
      missing_(active_.size(), 0),
      placed_(object_count, false),
      seen_poses_(object_count),
      is_held_(active_.size(), 0),
      seen_frames_(object_count, FrameOf(Pose<double>())) {
  const auto soft = std::stable_partition(active_.begin(), active_.end(), [&](int t) { return terms_[t].hard; });
  hard_count_ = static_cast<int>(soft - active_.begin());
  size_t most_operands = 0;
  for (int slot = 0; slot < static_cast<int>(active_.size()); ++slot) {
    const Term& term = terms_[active_[slot]];
    for (int object : term.cost->objects()) {
      touching_[object].push_back(slot);
      hard_touching_[object] += term.hard ? 1 : 0;
    }
    for (int object : term.required) requiring_[object].push_back(slot);
    missing_[slot] = static_cast<int>(term.required.size());
    Pair& pair = pairs_.emplace_back();
    if (term.required.size() == 2) {
      pair = {term.required.front(), term.required.back(), term.reach_m * term.reach_m};
    }
    most_operands = std::max(most_operands, term.cost->objects().size());
  }
  operands_.resize(most_operands);
  operand_gradient_.resize(3 * most_operands);
}

void Problem::SetPlaced(int object, bool placed) {
  if (static_cast<bool>(placed_[object]) == placed) return;
  placed_[object] = placed;
  for (int slot : requiring_[object]) missing_[slot] += placed ? -1 : 1;
}

const Frame<double>& Problem::FrameAt(int object, std::span<const Pose<double>> poses) {
  if (!(seen_poses_[object] == poses[object])) {
    seen_poses_[object] = poses[object];
    seen_frames_[object] = FrameOf(poses[object]);
  }
  return seen_frames_[object];
}

std::span<const Frame<double>> Problem::Gather(int slot, std::span<const Pose<double>> poses) {
  const std::span<const int> objects = terms_[active_[slot]].cost->objects();
  for (size_t k = 0; k < objects.size(); ++k) operands_[k] = FrameAt(objects[k], poses);
  return {operands_.data(), objects.size()};
}

double Problem::Value(int slot, std::span<const Pose<double>> poses) {
  ++evaluations_;
  if (Apart(slot, poses)) return 0;
  const Term& term = terms_[active_[slot]];
  return term.Loss(term.cost->ValueAt(Gather(slot, poses)));
}

double Problem::Total(std::span<const Pose<double>> poses) {
  double sum = 0;
  for (int slot = 0; slot < static_cast<int>(active_.size()); ++slot) {
    if (missing_[slot] == 0) sum += Value(slot, poses);
  }
  return sum;
}

double Problem::Around(int object, std::span<const Pose<double>> poses, double limit) {
  double sum = 0;
  for (int slot : touching_[object]) {
    if (missing_[slot] != 0) continue;
    sum += Value(slot, poses);
    if (sum > limit) return sum;
  }
  return sum;
}

void Problem::Hold(std::span<const int> objects, std::span<const Pose<double>> poses, bool soft_only) {
  held_.clear();
  moves_.clear();
  held_frames_.clear();
  moved_frames_.resize(objects.size());
  for (int object : objects) {
    for (size_t i = soft_only ? hard_touching_[object] : 0; i < touching_[object].size(); ++i) {
      const int slot = touching_[object][i];
      if (missing_[slot] != 0 || is_held_[slot]) continue;
      is_held_[slot] = 1;
      HoldTerm(slot, objects, poses);
    }
  }
  for (int object : objects) {
    for (int slot : touching_[object]) is_held_[slot] = 0;
  }
}

void Problem::HoldTerm(int slot, std::span<const int> held, std::span<const Pose<double>> poses) {
  const Term& term = terms_[active_[slot]];
  const std::span<const int> objects = term.cost->objects();
  const std::span<const Frame<double>> frames = Gather(slot, poses);
  HeldTerm entry{&term, held_frames_.size(), moves_.size(), 0, 0};
  for (size_t h = 0; h < held.size(); ++h) {
    const auto operand = std::lower_bound(objects.begin(), objects.end(), held[h]);
    if (operand == objects.end() || *operand != held[h]) continue;
    moves_.push_back({static_cast<size_t>(operand - objects.begin()), h});
    ++entry.move_count;
  }
  if (entry.move_count == 1) entry.fixed_part = term.cost->FixedPart(frames, moves_.back().operand);
  held_.push_back(entry);
  held_frames_.insert(held_frames_.end(), frames.begin(), frames.end());
}

double Problem::AroundHeld(std::span<const Pose<double>> poses, double limit) {
  for (size_t h = 0; h < poses.size(); ++h) moved_frames_[h] = FrameOf(poses[h]);
  double sum = 0;
  for (const HeldTerm& held : held_) {
    ++evaluations_;
    const std::span<Frame<double>> frames(held_frames_.data() + held.first, held.term->cost->objects().size());
    const std::span<const Move> moves(moves_.data() + held.first_move, held.move_count);
    for (const Move& move : moves) frames[move.operand] = moved_frames_[move.held];
    const double cost = held.move_count == 1 ? held.term->cost->ValueGiven(held.fixed_part, frames, moves[0].operand)
                                             : held.term->cost->ValueAt(frames);
    sum += held.term->Loss(cost);
    if (sum > limit) return sum;
  }
  return sum;
}

double Problem::Gradient(std::span<const Pose<double>> poses, std::span<double> gradient) {
  double sum = 0;
  for (int slot = 0; slot < static_cast<int>(active_.size()); ++slot) {
    if (missing_[slot] != 0) continue;
    ++evaluations_;
    if (Apart(slot, poses)) continue;
    const Term& term = terms_[active_[slot]];
    const std::span<const int> objects = term.cost->objects();
    const std::span<double> part(operand_gradient_.data(), 3 * objects.size());
    const double cost = term.cost->GradientAt(Gather(slot, poses), part);
    sum += term.Loss(cost);
    const double slope = term.Slope(cost);
    for (size_t k = 0; k < objects.size(); ++k) {
      for (int c = 0; c < 3; ++c) gradient[3 * objects[k] + c] += slope * part[3 * k + c];
    }
  }
  return sum;
}

double Problem::Hard(std::span<const Pose<double>> poses) {
  double sum = 0;
  for (int slot = 0; slot < hard_count_; ++slot) {
    if (missing_[slot] == 0) sum += Value(slot, poses);
  }
  return sum;
}

ProblemObjective::ProblemObjective(Problem& problem, std::vector<Pose<double>>& poses, std::vector<int> free, bool turn)
    : problem_(problem),
      poses_(poses),
      free_(std::move(free)),
      stride_(turn ? 3 : 2),
      full_gradient_(3 * poses.size(), 0.0) {}

double ProblemObjective::Evaluate(std::span<const double> x, std::span<double> gradient) {
  Apply(x);
  if (gradient.empty()) return problem_.Total(poses_);
  std::fill(full_gradient_.begin(), full_gradient_.end(), 0.0);
  const double value = problem_.Gradient(poses_, full_gradient_);
  for (size_t i = 0; i < free_.size(); ++i) {
    for (int c = 0; c < stride_; ++c) gradient[i * stride_ + c] = full_gradient_[3 * free_[i] + c];
  }
  return value;
}

std::vector<double> ProblemObjective::Start() const {
  std::vector<double> x;
  for (int object : free_) {
    x.push_back(poses_[object].x_m);
    x.push_back(poses_[object].y_m);
    if (stride_ == 3) x.push_back(poses_[object].theta_rad);
  }
  return x;
}

void ProblemObjective::Apply(std::span<const double> x) {
  for (size_t i = 0; i < free_.size(); ++i) {
    Pose<double>& pose = poses_[free_[i]];
    pose.x_m = x[i * stride_];
    pose.y_m = x[i * stride_ + 1];
    if (stride_ == 3) pose.theta_rad = x[i * stride_ + 2];
  }
}

}  // namespace flair::optimizer
