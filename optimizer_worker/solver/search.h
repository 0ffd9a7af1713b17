// SPDX-License-Identifier: GPL-3.0-or-later
// Places objects by trying candidate poses against the true cost: greedy construction, sweeps that re-place one object
// at a time, moves of a piece together with what belongs to it, and a gradient descent at the end.
#pragma once

#include <span>
#include <vector>

#include "evaluation/metrics/walk_grid.h"
#include "optimizer_worker/constraints/linked_pairs.h"
#include "optimizer_worker/solver/candidates.h"
#include "optimizer_worker/solver/hard_cost.h"
#include "optimizer_worker/solver/problem.h"
#include "optimizer_worker/solver/solver.h"
#include "room/scene/room.h"

namespace flair::optimizer {

// What the walkability of a layout is worth, in units of cost: the paper has no term for it. Small against a constraint that
// is missed, large against nearly equal minima.
struct WalkWeights {
  double unreachable_floor = 7.0;
  double blocked_front = 1.2;
  double blocked_door = 2.0;
  // Per m3, see CrowdingCost_m3.
  double crowding = 3.0;
};

// All that a search reads. Borrowed; must outlive it.
struct SearchInput {
  const Scene& scene;
  // Per object, the objects that edges name together with it.
  const std::vector<std::vector<int>>& partners;
  std::span<const Vec2<double>> zone_centers;
  const Solver& solver;
  const KeepOut& keep_out;
  // Null when walking does not matter (tertiaries).
  const evaluation::WalkGrid* walk_grid = nullptr;
  WalkWeights walk_weights;
  // Ends improvements between two moves, with the best layout so far. Objects under construction still get a pose.
  StopCheck stop;
  // What belongs before a front does not block it: a chair its desk, nor the desk its chair. Null when anything does.
  const LinkedPairs* linked = nullptr;

  bool Stopped() const { return stop && stop(); }
};

class LayoutSearch {
 public:
  // `problem` says what is placed already; `layout` has a pose for those.
  LayoutSearch(const SearchInput& input, Problem problem, Layout layout);

  // Places `objects` in this order, each where the cost is least; `noise` > 0 adds up to that much to each candidate.
  void Construct(std::span<const int> objects, double noise, Random& random);
  // Places one object anew where it collides with nothing, if there is such a place.
  void PlaceClear(int object, Random& random);
  // Re-places each of `objects` while that helps, at most `rounds` times round.
  void Sweep(std::span<const int> objects, int rounds, const CandidateDensity& density, Random& random);
  // Moves `anchor` and the objects attached to it as one piece to the best candidate, if that helps.
  bool MoveTogether(int anchor, std::span<const int> members, const CandidateDensity& density, Random& random);
  // Slides each of `objects`, alone and with those attached to it (`members_of`), until it touches what is beside it or
  // leaves a way, while that helps; never makes the hard terms worse. For layouts that are exact already.
  void Settle(std::span<const int> objects, std::span<const std::vector<int>> members_of);
  // Takes objects out and places them anew; keeps the result only if the score falls.
  bool Replace(std::span<const int> objects, double noise, Random& random);
  // Descends along the gradient over x, y, theta of `objects`; many of them a part at a time.
  SolverReport Descend(std::span<const int> objects, const SolverLimits& limits);

  // Cost plus what bad walkability is worth.
  double Score();
  double Cost() { return problem_.Total(layout_); }
  // What the ways through the present layout cost; kept until an object moves.
  double WalkPenalty();
  const Layout& layout() const { return layout_; }
  void set_layout(const Layout& layout) { layout_ = layout; }
  Problem& problem() { return problem_; }
  int64_t evaluations() const { return problem_.evaluations(); }

 private:
  struct Choice {
    Pose<double> pose;
    double cost;
  };
  SolverReport DescendTogether(std::span<const int> objects, const SolverLimits& limits);
  // Tries the slides of `group` as one piece, its first object leading; true when one was taken.
  bool SettleGroup(std::span<const int> group);
  // How many obstacles (of the last measure) cannot be stood before, though nothing that belongs there stands there.
  int BlockedFronts() const;
  // The candidate poses of `object`, given all else, into candidates_.
  void Propose(int object, const CandidateDensity& density, Random& random);
  // The same and poses near the present one.
  void ProposeNear(int object, const CandidateDensity& density, Random& random);
  // The best few of candidates_, best first.
  void Rank(int object, double limit, double noise, Random& random, size_t keep);

  const SearchInput& input_;
  Problem problem_;
  Layout layout_;
  HardCost hard_cost_;
  Layout walk_layout_;  // the layout that walk_penalty_ is of
  double walk_penalty_ = 0;
  std::vector<evaluation::WalkGrid> walk_grid_;  // none or one: a private copy
  std::vector<int> placed_;
  std::vector<Pose<double>> candidates_;
  std::vector<Choice> choices_;
  std::vector<evaluation::Obstacle> obstacles_;  // of the last walk, and which objects they are
  std::vector<int> walked_;
};

// How narrow the gaps are that furniture leaves: what the pathway cost of a layout will be, without its medial axis.
// Sum over pairs of obstacles, and obstacles and walls, of  length * F(gap)  [m3]
//   gap     between two sides that face each other in parallel, above 0.02 m (less is touching) and below 0.6 m
//   length  on which they face each other
//   F       [Paper] cross-section of the pathway cost in the middle of such a gap: sum_{k=1..3} w_k max(0.1 k - gap/2,
//   0)^2
//           for each side that is furniture, w = 3 2 1
// Pairs at other angles than multiples of 90 degrees do not count, and nothing that stands in between is seen.
double CrowdingCost_m3(const Room& room, std::span<const evaluation::Obstacle> obstacles);

}  // namespace flair::optimizer
