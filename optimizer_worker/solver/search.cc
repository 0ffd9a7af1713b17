// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/solver/search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "optimizer_worker/solver/separation.h"
#include "room/geometry/gap.h"

namespace flair::optimizer {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
// A re-placement must gain this much, or rounding would move things forever.
constexpr double kLeastGain = 1e-7;
// How many of the best poses of an object are also judged by walkability.
constexpr size_t kWalkChoices = 6;
// An object that costs less than this, in a room whose ways cost less than that, stays where it is.
constexpr double kContent = 1e-4, kWalkable = 0.1;
constexpr double kBox_m = 0.3;
constexpr int kSettleRounds = 3;
// Hard terms may grow by this when things touch.
constexpr double kRounding = 1e-12;
// Hard terms of an object that touches others.
constexpr double kClear = 1e-9;
// Free floor that a slid object leaves before a neighbour.
constexpr double kWay_m = 0.6;
// A step of SLSQP grows with the cube of the variables and cannot be interrupted. More objects than kMostTogether (no
// room that people live in) descend kBlock at a time.
constexpr size_t kMostTogether = 60, kBlock = 20;
// So many poses of an object are looked at when time is up; most objects of a usual room have fewer.
constexpr size_t kHasty = 300;

void KeepEvenly(size_t most, std::vector<Pose<double>>& poses) {
  if (poses.size() <= most) return;
  for (size_t i = 0; i < most; ++i) poses[i] = poses[i * poses.size() / most];
  poses.resize(most);
}

}  // namespace

LayoutSearch::LayoutSearch(const SearchInput& input, Problem problem, Layout layout)
    : input_(input),
      problem_(std::move(problem)),
      layout_(std::move(layout)),
      hard_cost_(input.scene, input.keep_out, problem_) {
  if (input.walk_grid) walk_grid_.push_back(*input.walk_grid);
  for (int i = 0; i < problem_.object_count(); ++i) {
    if (!problem_.placed(i)) layout_[i] = FarAway(i);
  }
}

double LayoutSearch::WalkPenalty() {
  if (walk_grid_.empty()) return 0;
  if (walk_layout_ == layout_) return walk_penalty_;
  walk_layout_ = layout_;
  obstacles_.clear();
  walked_.clear();
  for (int i = 0; i < problem_.object_count(); ++i) {
    if (problem_.placed(i) && IsSolid(input_.scene.objects[i])) {
      obstacles_.push_back({layout_[i], input_.scene.objects[i].footprint});
      walked_.push_back(i);
    }
  }
  const evaluation::WalkResult walk = walk_grid_.front().Measure(obstacles_);
  const WalkWeights& weights = input_.walk_weights;
  walk_penalty_ = weights.unreachable_floor * (1 - walk.reachable_share) + weights.blocked_front * BlockedFronts() +
                  (walk.door_free ? 0.0 : weights.blocked_door) +
                  weights.crowding * CrowdingCost_m3(input_.scene.room, obstacles_);
  return walk_penalty_;
}

int LayoutSearch::BlockedFronts() const {
  const std::vector<char>& reachable = walk_grid_.front().front_reachable();
  int blocked = 0;
  for (size_t i = 0; i < obstacles_.size(); ++i) {
    if (reachable[i]) continue;
    const evaluation::Obstacle& own = obstacles_[i];
    const auto strip = Box<double>::Before(own.footprint, FrameOf(own.pose), Side::kFront, evaluation::kFrontStrip_m);
    bool belongs = false;
    for (size_t k = 0; input_.linked != nullptr && k < obstacles_.size() && !belongs; ++k) {
      belongs = input_.linked->BelongsAt(walked_[i], walked_[k], Side::kFront) &&
                Gap<double>(strip, Box<double>(obstacles_[k].footprint, FrameOf(obstacles_[k].pose))) < 0;
    }
    blocked += belongs ? 0 : 1;
  }
  return blocked;
}

double LayoutSearch::Score() { return problem_.Total(layout_) + WalkPenalty(); }

void LayoutSearch::Propose(int object, const CandidateDensity& density, Random& random) {
  placed_.clear();
  for (int i = 0; i < problem_.object_count(); ++i) {
    if (i != object && problem_.placed(i)) placed_.push_back(i);
  }
  candidates_.clear();
  const CandidateContext context{input_.scene, layout_, placed_, input_.partners[object], input_.zone_centers};
  ProposeCandidates(context, object, density, random, candidates_);
  // Rooms too small for any proposal still get one: the middle.
  if (candidates_.empty()) {
    const Vec2<double> middle = BoundsOf(input_.scene.room.floor).Center();
    candidates_.push_back({middle.x, middle.y, 0});
  }
}

void LayoutSearch::ProposeNear(int object, const CandidateDensity& density, Random& random) {
  Propose(object, density, random);
  ProposeNudges(layout_[object], random, candidates_);
  if (walk_grid_.empty() || !IsSolid(input_.scene.objects[object])) return;
  const CandidateContext context{input_.scene, layout_, placed_, input_.partners[object], input_.zone_centers};
  ProposeSlides(context, object, layout_[object], kWay_m, candidates_);
}

void LayoutSearch::Rank(int object, double limit, double noise, Random& random, size_t keep) {
  choices_.clear();
  const bool solid = IsSolid(input_.scene.objects[object]);
  if (solid) hard_cost_.Prepare({&object, 1}, problem_, layout_);
  problem_.Hold({&object, 1}, layout_, solid);
  for (const Pose<double>& candidate : candidates_) {
    const double handicap = noise > 0 ? noise * random.Uniform() : 0.0;
    const double bound = choices_.size() < keep ? limit : std::min(limit, choices_.back().cost);
    double cost = handicap;
    if (solid) cost += hard_cost_.At({&candidate, 1}, bound - cost);
    if (cost >= bound) continue;
    cost += problem_.AroundHeld({&candidate, 1}, bound - cost);
    if (cost >= bound) continue;
    const auto place = std::upper_bound(choices_.begin(), choices_.end(), cost,
                                        [](double value, const Choice& choice) { return value < choice.cost; });
    if (choices_.size() == keep && place == choices_.end()) continue;
    choices_.insert(place, {candidate, cost});
    if (choices_.size() > keep) choices_.pop_back();
  }
}

void LayoutSearch::Construct(std::span<const int> objects, double noise, Random& random) {
  for (int object : objects) {
    problem_.SetPlaced(object, true);
    Propose(object, CandidateDensity{}, random);
    // When time is up the rest is placed, but after a short look.
    if (input_.Stopped()) KeepEvenly(kHasty, candidates_);
    Rank(object, kNever, noise, random, 1);
    layout_[object] = choices_.empty() ? candidates_.front() : choices_.front().pose;
  }
}

void LayoutSearch::PlaceClear(int object, Random& random) {
  Propose(object, CandidateDensity{}, random);
  hard_cost_.Prepare({&object, 1}, problem_, layout_);
  std::erase_if(candidates_, [&](const Pose<double>& pose) { return hard_cost_.At({&pose, 1}, kClear) > kClear; });
  Rank(object, kNever, 0, random, 1);
  if (!choices_.empty()) layout_[object] = choices_.front().pose;
}

void LayoutSearch::Sweep(std::span<const int> objects, int rounds, const CandidateDensity& density, Random& random) {
  for (int round = 0; round < rounds; ++round) {
    bool moved = false;
    for (int object : objects) {
      if (input_.Stopped()) return;
      const Pose<double> before = layout_[object];
      const double cost_before = problem_.Around(object, layout_, kNever);
      const double walk_before = WalkPenalty();
      if (cost_before < kContent && walk_before < kWalkable) continue;
      ProposeNear(object, density, random);
      // A pose may cost a little more when it frees the way.
      Rank(object, cost_before + walk_before, 0, random, walk_grid_.empty() ? 1 : kWalkChoices);
      double best = cost_before + walk_before - kLeastGain;
      Pose<double> chosen = before;
      for (const Choice& choice : choices_) {
        if (choice.cost >= best) break;
        layout_[object] = choice.pose;
        const double score = choice.cost + WalkPenalty();
        if (score >= best) continue;
        best = score;
        chosen = choice.pose;
        moved = true;
      }
      layout_[object] = chosen;
    }
    if (!moved) return;
  }
}

bool LayoutSearch::MoveTogether(int anchor, std::span<const int> members, const CandidateDensity& density,
                                Random& random) {
  if (input_.Stopped()) return false;
  const Layout before = layout_;
  const Frame<double> old_frame = FrameOf(before[anchor]);
  std::vector<int> group = {anchor};
  group.insert(group.end(), members.begin(), members.end());
  std::vector<Pose<double>> start, moved, best;
  for (int object : group) start.push_back(before[object]);
  moved = start;
  ProposeNear(anchor, density, random);
  problem_.Hold(group, layout_, false);
  const double cost_before = problem_.AroundHeld(start, kNever);
  const double walk_before = WalkPenalty();
  // The best pose by cost, then one look at the way: a little more cost may free it.
  double least = cost_before + walk_before;
  for (const Pose<double>& candidate : candidates_) {
    const Frame<double> frame = FrameOf(candidate);
    moved[0] = candidate;
    for (size_t k = 1; k < group.size(); ++k) {
      const Vec2<double> local = old_frame.ToObject(Center(start[k]));
      const Vec2<double> p = frame.ToRoom(local.x, local.y);
      moved[k] = {p.x, p.y, start[k].theta_rad + candidate.theta_rad - start[0].theta_rad};
    }
    const double cost = problem_.AroundHeld(moved, least);
    if (cost >= least) continue;
    least = cost;
    best = moved;
  }
  if (best.empty()) return false;
  for (size_t k = 0; k < group.size(); ++k) layout_[group[k]] = best[k];
  if (least + WalkPenalty() < cost_before + walk_before - kLeastGain) return true;
  layout_ = before;
  return false;
}

bool LayoutSearch::SettleGroup(std::span<const int> group) {
  const Layout before = layout_;
  placed_.clear();
  for (int i = 0; i < problem_.object_count(); ++i) {
    if (problem_.placed(i) && std::find(group.begin(), group.end(), i) == group.end()) placed_.push_back(i);
  }
  const CandidateContext context{input_.scene, layout_, placed_, input_.partners[group[0]], input_.zone_centers};
  candidates_.clear();
  for (int object : group) {
    const size_t first = candidates_.size();
    ProposeSlides(context, object, before[object], kWay_m, candidates_);
    ProposeSlidesOffCorners(input_.scene.room, input_.scene.objects[object].footprint, before[object], kWay_m,
                            candidates_);
    // As slides of the leader.
    for (size_t i = first; i < candidates_.size(); ++i) {
      candidates_[i].x_m += before[group[0]].x_m - before[object].x_m;
      candidates_[i].y_m += before[group[0]].y_m - before[object].y_m;
      candidates_[i].theta_rad = before[group[0]].theta_rad;
    }
  }
  const double hard_before = problem_.Hard(before);
  double least = problem_.Total(before) + WalkPenalty() - kLeastGain;
  Layout best;
  for (const Pose<double>& candidate : candidates_) {
    for (int object : group) {
      layout_[object].x_m = before[object].x_m + candidate.x_m - before[group[0]].x_m;
      layout_[object].y_m = before[object].y_m + candidate.y_m - before[group[0]].y_m;
    }
    const double cost = problem_.Total(layout_);
    if (cost >= least || problem_.Hard(layout_) > hard_before + kRounding) continue;
    const double score = cost + WalkPenalty();
    if (score >= least) continue;
    least = score;
    best = layout_;
  }
  layout_ = best.empty() ? before : best;
  return !best.empty();
}

void LayoutSearch::Settle(std::span<const int> objects, std::span<const std::vector<int>> members_of) {
  for (int round = 0; round < kSettleRounds; ++round) {
    bool moved = false;
    for (size_t i = 0; i < objects.size(); ++i) {
      if (input_.Stopped()) return;
      moved |= SettleGroup({&objects[i], 1});
      if (members_of[i].empty()) continue;
      std::vector<int> group = {objects[i]};
      group.insert(group.end(), members_of[i].begin(), members_of[i].end());
      moved |= SettleGroup(group);
    }
    if (!moved) return;
  }
}

bool LayoutSearch::Replace(std::span<const int> objects, double noise, Random& random) {
  if (input_.Stopped()) return false;
  const Layout before = layout_;
  const double score_before = Score();
  for (int object : objects) {
    problem_.SetPlaced(object, false);
    layout_[object] = FarAway(object);
  }
  Construct(objects, noise, random);
  if (problem_.Total(layout_) < score_before && Score() < score_before - kLeastGain) return true;
  layout_ = before;
  return false;
}

SolverReport LayoutSearch::Descend(std::span<const int> objects, const SolverLimits& limits) {
  if (objects.size() <= kMostTogether) return DescendTogether(objects, limits);
  SolverReport report;
  for (size_t first = 0; first < objects.size(); first += kBlock) {
    const std::span<const int> block = objects.subspan(first, std::min(kBlock, objects.size() - first));
    const int64_t before = report.evaluations;
    report = DescendTogether(block, limits);
    report.evaluations += before;
  }
  return report;
}

SolverReport LayoutSearch::DescendTogether(std::span<const int> objects, const SolverLimits& limits) {
  if (input_.Stopped()) return {.value = Cost(), .end = SolverEnd::kStoppedEarly};
  ProblemObjective objective(problem_, layout_, {objects.begin(), objects.end()}, true);
  std::vector<double> x = objective.Start();
  Bounds bounds;
  const BoundingBox box = BoundsOf(input_.scene.room.floor);
  for (size_t i = 0; i < objects.size(); ++i) {
    bounds.lower.insert(bounds.lower.end(), {box.min.x - kBox_m, box.min.y - kBox_m, x[3 * i + 2] - 1.0});
    bounds.upper.insert(bounds.upper.end(), {box.max.x + kBox_m, box.max.y + kBox_m, x[3 * i + 2] + 1.0});
  }
  SolverLimits stoppable = limits;
  stoppable.stop = &input_.stop;
  const SolverReport report = input_.solver.Minimize(objective, bounds, stoppable, x);
  objective.Apply(x);
  return report;
}

namespace {

constexpr double kTouching_m = 0.02, kNarrow_m = 0.6;
// sin of the largest angle that passes for parallel.
constexpr double kParallel = 0.05;

double Square(double x) { return x * x; }

// F for one side that is furniture.
double CrossSection_m2(double gap_m) {
  double sum = 0;
  for (int k = 1; k <= 3; ++k) sum += (4 - k) * Square(std::max(0.0, 0.1 * k - gap_m / 2));
  return sum;
}

double Overlap(double low_a, double high_a, double low_b, double high_b) {
  return std::min(high_a, high_b) - std::max(low_a, low_b);
}

// `length_m` may be negative: then the two are not opposite each other.
double GapCost(double gap_m, double length_m) {
  if (length_m <= 0 || gap_m <= kTouching_m || gap_m >= kNarrow_m) return 0;
  return length_m * CrossSection_m2(gap_m);
}

struct Placed {
  Frame<double> frame;
  double half_width_m, half_depth_m, reach_m;
};

double PairCost(const Placed& a, const Placed& b) {
  const double reach = a.reach_m + b.reach_m + kNarrow_m;
  if (SquaredNorm(a.frame.center - b.frame.center) >= reach * reach) return 0;
  const double c = Dot(a.frame.right, b.frame.right), s = Dot(a.frame.front, b.frame.right);
  if (std::abs(c * s) > kParallel) return 0;
  const bool turned = std::abs(s) > 0.5;
  const double u = turned ? b.half_depth_m : b.half_width_m, v = turned ? b.half_width_m : b.half_depth_m;
  const Vec2<double> p = a.frame.ToObject(b.frame.center);
  const double gap_u = std::abs(p.x) - a.half_width_m - u, gap_v = std::abs(p.y) - a.half_depth_m - v;
  return 2 * (GapCost(gap_u, Overlap(-a.half_depth_m, a.half_depth_m, p.y - v, p.y + v)) +
              GapCost(gap_v, Overlap(-a.half_width_m, a.half_width_m, p.x - u, p.x + u)));
}

double WallCost(const Placed& a, const Wall& wall) {
  const double height = wall.Height(a.frame.center), offset = wall.Offset(a.frame.center);
  if (height >= a.reach_m + kNarrow_m) return 0;
  const double c = Dot(a.frame.front, wall.inward_normal), s = Dot(a.frame.right, wall.inward_normal);
  if (std::abs(c * s) > kParallel) return 0;
  const bool turned = std::abs(s) > 0.5;
  const double half_length = turned ? a.half_depth_m : a.half_width_m;
  return GapCost(height - (turned ? a.half_width_m : a.half_depth_m),
                 Overlap(0, wall.length_m, offset - half_length, offset + half_length));
}

}  // namespace

double CrowdingCost_m3(const Room& room, std::span<const evaluation::Obstacle> obstacles) {
  double sum = 0;
  // Rooms hold tens of obstacles; more are cut off rather than allocated for.
  constexpr size_t kMost = 128;
  Placed placed[kMost];
  const size_t count = std::min(kMost, obstacles.size());
  for (size_t i = 0; i < count; ++i) {
    const Footprint& footprint = obstacles[i].footprint;
    placed[i] = {FrameOf(obstacles[i].pose), footprint.width_m / 2, footprint.depth_m / 2,
                 CircumscribedRadius(footprint)};
    for (size_t k = 0; k < i; ++k) sum += PairCost(placed[i], placed[k]);
    for (const Wall& wall : room.walls) sum += WallCost(placed[i], wall);
  }
  return sum;
}

}  // namespace flair::optimizer
