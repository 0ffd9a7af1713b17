// SPDX-License-Identifier: GPL-3.0-or-later
// A sum of weighted costs over the poses of a scene's objects, of which some are free to move.
#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/solver/solver.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {

// One summand. Shared by all problems of a solve.
struct Term {
  std::unique_ptr<const Cost> cost;
  // Factor in the search: lambda or edge weight, raised by `kHardFactor` for hard terms.
  double weight = 1;
  // Objects that must be placed for the term to count; the cost may read others, which stand far away until then.
  std::vector<int> required;
  // Of a term of two objects that both have to be placed: its cost is 0 when their centres are at least this far apart.
  double reach_m = std::numeric_limits<double>::infinity();
  // Overlap, bounds and doors: must be zero in the end.
  bool hard = false;
  // Counts as RobustLoss(cost): one soft constraint missed is better than five missed a little.
  bool robust = false;
  // What a term that is not robust can cost at most: balance and zones lead, but are worth no more than a call.
  double most = std::numeric_limits<double>::infinity();
  // Index of the graph's edge, or -1 for a whole-room term called `name`.
  int edge = -1;
  std::string name;
  // The paper's factor of a whole-room term, without `kHardFactor`.
  double factor = 1;

  // What a cost counts in the search, and how fast that grows with the cost.
  double Loss(double cost_value) const;
  double Slope(double cost_value) const;
};

// The paper's penalties compete with the soft constraints; the search must not trade one for an overlap. Multiplies factors of
// hard terms that are smaller than this.
inline constexpr double kHardFactor = 40;

// Robust loss of a soft constraint of cost c:
//   kHopeless log(1 + c / kHopeless) + kMissed c / (c + kNearly)
// Zero where c is zero, grows with c, adds almost kMissed as soon as the constraint is missed at all, and grows slowly when
// it is missed by far: least squares alone would rather miss every constraint by some centimetres than one of them honestly,
// and let one that cannot be met (2 m from the door in a 3 m room) spoil the others.
inline constexpr double kMissed = 0.9;
inline constexpr double kNearly = 0.01;
inline constexpr double kHopeless = 0.2;
inline double RobustLoss(double cost) { return kHopeless * std::log1p(cost / kHopeless) + kMissed * cost / (cost + kNearly); }
inline double RobustSlope(double cost) {
  return kHopeless / (kHopeless + cost) + kMissed * kNearly / ((cost + kNearly) * (cost + kNearly));
}

inline double Term::Loss(double cost_value) const {
  const double x = weight * cost_value;
  return robust ? weight * RobustLoss(cost_value) : x / (1 + x / most);
}
inline double Term::Slope(double cost_value) const {
  const double damping = 1 + weight * cost_value / most;
  return robust ? weight * RobustSlope(cost_value) : weight / (damping * damping);
}

// Where objects stand that are not placed yet: so far away that no cost between them and the room acts.
Pose<double> FarAway(int object);

// Evaluates a set of terms. Keeps scratch memory, so one Problem serves one thread; copies are cheap and independent.
// `terms` must outlive it.
class Problem {
 public:
  // Counts the terms chosen by `active` (indices into `terms`), over `object_count` objects.
  Problem(std::span<const Term> terms, std::vector<int> active, int object_count);

  // Says that an object has (or has not) a pose; terms that require a missing one do not count.
  void SetPlaced(int object, bool placed);
  bool placed(int object) const { return placed_[object]; }

  // Sum of all terms that count.
  double Total(std::span<const Pose<double>> poses);
  // Sum of the terms that read `object`; may stop early with any number above `limit`.
  double Around(int object, std::span<const Pose<double>> poses, double limit);

  // For trying many poses of `objects` while all others stay as in `poses`: works out once what they share. With
  // `soft_only` the hard terms are left out.
  void Hold(std::span<const int> objects, std::span<const Pose<double>> poses, bool soft_only);
  // Sum of the terms that read any of the held objects, with these at `poses` (in Hold's order); may stop early with
  // any number above `limit`. Valid until the next Hold or SetPlaced.
  double AroundHeld(std::span<const Pose<double>> poses, double limit);

  // Sum of all terms that count; adds each gradient into `gradient`, three numbers per object of the scene.
  double Gradient(std::span<const Pose<double>> poses, std::span<double> gradient);
  // Sum of the hard terms.
  double Hard(std::span<const Pose<double>> poses);

  int64_t evaluations() const { return evaluations_; }
  int object_count() const { return static_cast<int>(placed_.size()); }
  std::span<const Term> terms() const { return terms_; }
  std::span<const int> active() const { return active_; }

 private:
  // A term that reads held objects; its operands' frames begin at held_frames_[first], its moves at moves_[first_move].
  struct HeldTerm {
    const Term* term;
    size_t first;
    size_t first_move;
    size_t move_count;
    double fixed_part;
  };
  // Where the frame of the held object number `held` goes among a term's operands.
  struct Move {
    size_t operand;
    size_t held;
  };
  // The two objects of a term that only acts near by. In a room of 200 objects 199 of 200 terms are of that kind and
  // most are apart: asking here costs a fraction of evaluating them.
  struct Pair {
    int first = 0;
    int second = 0;
    double squared_reach_m2 = std::numeric_limits<double>::infinity();
  };
  bool Apart(int slot, std::span<const Pose<double>> poses) const {
    const Pair& pair = pairs_[slot];
    const double dx = poses[pair.first].x_m - poses[pair.second].x_m;
    const double dy = poses[pair.first].y_m - poses[pair.second].y_m;
    return dx * dx + dy * dy >= pair.squared_reach_m2;
  }
  void HoldTerm(int slot, std::span<const int> held, std::span<const Pose<double>> poses);
  double Value(int slot, std::span<const Pose<double>> poses);
  const Frame<double>& FrameAt(int object, std::span<const Pose<double>> poses);
  std::span<const Frame<double>> Gather(int slot, std::span<const Pose<double>> poses);

  std::span<const Term> terms_;
  std::vector<int> active_;                 // slot -> term, hard terms first
  std::vector<Pair> pairs_;                 // per slot
  std::vector<std::vector<int>> touching_;  // object -> slots, hard terms first
  int hard_count_ = 0;
  std::vector<int> hard_touching_;  // object -> how many of those are hard
  std::vector<std::vector<int>> requiring_;
  std::vector<int> missing_;  // slot -> required objects without a pose
  std::vector<char> placed_;
  // The frames of the poses seen last: most objects stay where they are from one evaluation to the next.
  std::vector<Pose<double>> seen_poses_;
  std::vector<Frame<double>> seen_frames_;
  std::vector<HeldTerm> held_;
  std::vector<Move> moves_;
  std::vector<char> is_held_;  // per slot, while Hold runs
  std::vector<Frame<double>> moved_frames_;
  std::vector<Frame<double>> held_frames_;
  std::vector<Frame<double>> operands_;
  std::vector<double> operand_gradient_;
  int64_t evaluations_ = 0;
};

// A Problem as an Objective of chosen objects: x, y and, if asked for, theta of each.
class ProblemObjective final : public Objective {
 public:
  // Both are borrowed; `poses` holds every object, those in `free` are overwritten by Evaluate.
  ProblemObjective(Problem& problem, std::vector<Pose<double>>& poses, std::vector<int> free, bool turn);
  int size() const override { return static_cast<int>(free_.size()) * stride_; }
  double Evaluate(std::span<const double> x, std::span<double> gradient) override;

  std::vector<double> Start() const;
  void Apply(std::span<const double> x);
  int stride() const { return stride_; }

 private:
  Problem& problem_;
  std::vector<Pose<double>>& poses_;
  std::vector<int> free_;
  int stride_;
  std::vector<double> full_gradient_;
};

}  // namespace flair::optimizer
