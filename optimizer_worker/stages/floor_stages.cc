// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/floor_stages.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "optimizer_worker/stages/patterns.h"
#include "optimizer_worker/stages/place_groups.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {

namespace {

constexpr int kFurnishSweeps = 3;
constexpr double kFurnishNoise = 0.3;

template <typename Item>
std::vector<Item> Shuffled(std::vector<Item> order, int restart, Random& random) {
  if (restart == 0) return order;
  for (int i = static_cast<int>(order.size()) - 1; i > 0; --i) std::swap(order[i], order[random.Below(i + 1)]);
  return order;
}

// The groups of `objects`, largest first; those of which not all are there without arrangements.
std::vector<Group> GroupsOf(const SolveInput& input, std::span<const int> objects) {
  std::vector<Group> groups;
  for (const Group& group : input.groups.all) {
    Group& part = groups.emplace_back(group);
    std::erase_if(part.objects, [&](int o) { return std::find(objects.begin(), objects.end(), o) == objects.end(); });
    if (part.objects.size() < group.objects.size()) part.arrangements.clear();
  }
  std::erase_if(groups, [](const Group& group) { return group.objects.empty(); });
  const auto area = [&](const Group& group) {
    double sum = 0;
    for (int member : group.objects) sum += input.scene.objects[member].footprint.area_m2();
    return sum;
  };
  std::stable_sort(groups.begin(), groups.end(), [&](const Group& a, const Group& b) { return area(a) > area(b); });
  return groups;
}

}  // namespace

RestartResult FurnishRestart(const SolveInput& input, const StageSpec& stage, const PartialLayout& before,
                             int restart) {
  Random random(RestartSeed(input.settings, stage, restart));
  const std::vector<Vec2<double>> centers = ZoneCenters(input.scene, before.placed, before.layout);
  const SceneCosts costs = BindCosts(input, centers);
  const SearchInput search_input = SearchInputOf(input, centers, &input.walk_grid.get());
  LayoutSearch search(search_input, MakeProblem(input, costs, stage, before), before.layout);

  const double noise = restart == 0 ? 0.0 : kFurnishNoise;
  std::vector<int> free = stage.objects;
  if (input.groups.all.empty()) {
    search.Construct(Shuffled(free, restart, random), noise, random);
  } else {
    // What stands in a pattern already stays there.
    std::erase_if(free, [&](int object) { return before.placed[object] != 0; });
    PlaceGroups(input, search_input, Shuffled(GroupsOf(input, free), restart, random), noise, random, search);
  }
  search.Sweep(free, kFurnishSweeps, CandidateDensity{}, random);
  const Layout swept = search.layout();
  const double swept_score = search.Score();
  search.Descend(free, {.max_evaluations = 40, .relative_tolerance = 1e-3, .absolute_tolerance = 1e-4});
  double score = search.Score();
  if (score > swept_score) {
    search.set_layout(swept);
    score = swept_score;
  }
  RestartResult result{restart, score, search.evaluations(), before};
  for (int object : stage.objects) result.state.Place(object, search.layout()[object]);
  return result;
}

namespace {

constexpr int kRounds = 4;
constexpr double kReach_m = 0.6;
constexpr double kLargestMove_m = 0.2;
// Kept between objects: above the solver's feasibility tolerance, below anything that counts.
constexpr double kMargin_m = 5e-8;
constexpr int kProjectionRounds = 300;
// Rows times variables. A room of 40 pieces has a third of it; with more, one step of SLSQP takes seconds that no stop
// can end, and the nearest point that keeps the rows is taken without asking for its cost.
constexpr size_t kLargestProgram = 150000;
// The same when time is up; a room of 25 pieces has about half of it.
constexpr size_t kLargestInHaste = 20000;

Bounds MakeBounds(std::span<const double> x, std::vector<LinearInequality> rows) {
  Bounds bounds;
  for (double value : x) {
    bounds.lower.push_back(value - kLargestMove_m);
    bounds.upper.push_back(value + kLargestMove_m);
  }
  bounds.inequalities = std::move(rows);
  return bounds;
}

double WorstOf(const std::vector<Violation>& violations) {
  double worst = 0;
  for (const Violation& violation : violations) worst = std::max(worst, violation.depth_m);
  return worst;
}

}  // namespace

void SnapHeadings(const Scene& scene, std::span<const int> objects, Layout& layout) {
  for (int object : objects) {
    double& theta = layout[object].theta_rad;
    double best = kSnap_rad;
    double snapped = theta;
    for (const Wall& wall : scene.room.walls) {
      const double off = theta - wall.BackHeading();
      const double turn = off - std::round(off / (kPi / 2)) * (kPi / 2);
      if (std::abs(turn) >= best) continue;
      best = std::abs(turn);
      snapped = wall.BackHeading() + std::round(off / (kPi / 2)) * (kPi / 2);
    }
    theta = WrapHeading(snapped);
  }
}

std::vector<Violation> MakeExact(const SolveInput& input, Problem& problem, std::span<const int> free, Layout& layout) {
  std::vector<int> moving, standing, all;
  for (int i = 0; i < static_cast<int>(input.scene.objects.size()); ++i) {
    if (!problem.placed(i) || !IsSolid(input.scene.objects[i])) continue;
    (std::find(free.begin(), free.end(), i) != free.end() ? moving : standing).push_back(i);
    all.push_back(i);
  }
  SnapHeadings(input.scene, moving, layout);
  std::vector<Violation> left = FindViolations(input.scene, input.keep_out, all, layout, kTouching_m);
  const SolverLimits limits{
      .max_evaluations = 40, .relative_tolerance = 1e-4, .absolute_tolerance = 1e-6, .stop = &input.cancelled};
  // Exact even when time is up; not when nobody waits.
  for (int round = 0; round < kRounds && !input.Cancelled(); ++round) {
    ProblemObjective objective(problem, layout, moving, false);
    std::vector<double> x = objective.Start();
    const std::vector<LinearInequality> rows =
        SeparationRows(input.scene, input.keep_out, moving, standing, layout, kReach_m, kMargin_m);
    const double unprojected = ProjectOntoRows(rows, x, kProjectionRounds);
    const std::vector<double> projected = x;
    if (rows.size() * x.size() > (input.OutOfTime() ? kLargestInHaste : kLargestProgram)) {
      objective.Apply(projected);
    } else {
      const SolverReport report = input.solver.Minimize(objective, MakeBounds(x, rows), limits, x);
      objective.Apply(report.violation <= std::max(kMargin_m, unprojected) ? x : projected);
    }
    left = FindViolations(input.scene, input.keep_out, all, layout, kTouching_m);
    if (WorstOf(left) <= kTouching_m) break;
  }
  std::stable_sort(left.begin(), left.end(),
                   [](const Violation& a, const Violation& b) { return a.depth_m > b.depth_m; });
  return left;
}

namespace {

constexpr int kPolishSweeps = 2;
constexpr double kPolishNoise = 0.2;
// What an angle that follows no wall has to be worth: less than one wish, more than what is won by a few degrees.
constexpr double kCrooked = 0.3;
// What a place off the middle of a front has to be worth to the ways and to the calls, and how far before the front
// something stands at it.
constexpr double kOffCenter = 0.2, kOffCenterOfCalls = 0.02, kBefore_m = 1, kAtMiddle_m = 1e-3;
// Hard terms may grow by this.
constexpr double kExact = 1e-12;
constexpr CandidateDensity kSparse{.wall_samples = 2, .floor_samples = 10, .partner_samples = 1};

// The smaller partners of an object: what moves along when it moves.
std::vector<int> MembersOf(const SolveInput& input, const StageSpec& stage, int anchor) {
  std::vector<int> members;
  const double area = input.scene.objects[anchor].footprint.area_m2();
  for (int partner : input.partners[anchor]) {
    const bool moves = std::find(stage.objects.begin(), stage.objects.end(), partner) != stage.objects.end();
    if (moves && input.scene.objects[partner].footprint.area_m2() < area) members.push_back(partner);
  }
  return members;
}

// An object and up to two of its partners, or two strangers.
std::vector<int> Neighbourhood(const SolveInput& input, const StageSpec& stage, Random& random) {
  std::vector<int> chosen = {stage.objects[random.Below(static_cast<int>(stage.objects.size()))]};
  std::vector<int> pool;
  for (int partner : input.partners[chosen[0]]) {
    if (std::find(stage.objects.begin(), stage.objects.end(), partner) != stage.objects.end()) pool.push_back(partner);
  }
  if (pool.empty() || random.Uniform() < 0.3) pool = stage.objects;
  for (int extra = 1 + random.Below(2); extra > 0; --extra) {
    const int candidate = pool[random.Below(static_cast<int>(pool.size()))];
    if (std::find(chosen.begin(), chosen.end(), candidate) == chosen.end()) chosen.push_back(candidate);
  }
  return chosen;
}

void Improve(const SolveInput& input, const StageSpec& stage, LayoutSearch& search, Random& random) {
  search.Sweep(stage.objects, kPolishSweeps, kSparse, random);
  for (int anchor : stage.objects) {
    const std::vector<int> members = MembersOf(input, stage, anchor);
    if (!members.empty()) search.MoveTogether(anchor, members, kSparse, random);
  }
  const int attempts = 2 * static_cast<int>(stage.objects.size());
  for (int i = 0; i < attempts; ++i) search.Replace(Neighbourhood(input, stage, random), kPolishNoise, random);
}

// Turns crooked pieces along the walls where that costs little: nobody asked for the angle.
void Straighten(const Scene& scene, std::span<const int> objects, Problem& problem, Layout& layout) {
  for (int object : objects) {
    const Pose<double> crooked = layout[object];
    const double straight = WrapAngle(4 * (crooked.theta_rad - scene.room.walls[0].BackHeading())) / 4;
    if (std::abs(straight) < kSnap_rad) continue;
    double least = problem.Around(object, layout, HUGE_VAL) + kCrooked;
    Pose<double> best = crooked;
    for (const Wall& wall : scene.room.walls) {
      const double quarters = (crooked.theta_rad - wall.BackHeading()) / (kPi / 2);
      for (double turn : {std::floor(quarters), std::ceil(quarters)}) {
        layout[object].theta_rad = wall.BackHeading() + turn * kPi / 2;
        const double cost = problem.Around(object, layout, least);
        if (cost >= least) continue;
        least = cost;
        best = layout[object];
      }
    }
    layout[object] = best;
  }
}

// Moves what stands before the front of something larger that it belongs to, such as a chair at its desk, to the middle
// of it where that costs little: nobody asked for one end. For layouts that are exact already.
void Center(const SolveInput& input, int object, LayoutSearch& search) {
  for (int larger : input.partners[object]) {
    const Footprint& theirs = input.scene.objects[larger].footprint;
    if (!search.problem().placed(larger) || input.linked.TieOf(object, larger) == 0 ||
        !input.linked.BelongsAt(larger, object, Side::kFront) ||
        theirs.width_m < input.scene.objects[object].footprint.width_m) {
      continue;
    }
    const Layout aside = search.layout();
    const Frame<double> frame = FrameOf(aside[larger]);
    const Vec2<double> at = frame.ToObject(flair::Center(aside[object]));
    const double ahead = at.y - theirs.depth_m / 2;
    if (std::abs(at.x) < kAtMiddle_m || std::abs(at.x) > theirs.width_m / 2 || ahead < 0 || ahead > kBefore_m) continue;
    const double most = search.Score() + kOffCenter, hard = search.problem().Hard(aside);
    const double most_of_calls = search.Cost() + kOffCenterOfCalls;
    const Vec2<double> middle = frame.ToRoom(0, at.y);
    Layout centered = aside;
    centered[object] = {middle.x, middle.y, aside[object].theta_rad};
    search.set_layout(centered);
    if (search.problem().Hard(centered) > hard + kExact || search.Cost() > most_of_calls || search.Score() > most) {
      search.set_layout(aside);
    }
  }
}

// `free`, and the groups that the objects of `violations` are in.
std::vector<int> WithGroupsOf(const SolveInput& input, std::span<const Violation> violations, std::vector<int> free) {
  for (const Violation& violation : violations) {
    for (int object : {violation.object, violation.other}) {
      if (object < 0 || input.groups.all.empty() || input.groups.of[object] < 0) continue;
      for (int mate : input.groups.all[input.groups.of[object]].objects) {
        if (std::find(free.begin(), free.end(), mate) == free.end()) free.push_back(mate);
      }
    }
  }
  return free;
}

// Descends from where `search` is, makes the layout exact and lets it settle. Returns the score. What of `whole` is not
// in `stage` moves only when nothing else helps.
double Finish(const SolveInput& input, const StageSpec& whole, const StageSpec& stage, const SearchInput& search_input,
              Random& random, LayoutSearch& search) {
  search.Descend(stage.objects, {.max_evaluations = 60, .relative_tolerance = 1e-4, .absolute_tolerance = 1e-5});
  Layout layout = search.layout();
  Straighten(input.scene, stage.objects, search.problem(), layout);
  std::vector<Violation> left = MakeExact(input, search.problem(), stage.objects, layout);
  if (!left.empty() && stage.objects.size() < whole.objects.size()) {
    // What is wedged beside a pattern goes elsewhere before the pattern gives way.
    search.set_layout(layout);
    for (const Violation& violation : left) {
      for (int object : {violation.object, violation.other}) {
        if (std::find(stage.objects.begin(), stage.objects.end(), object) == stage.objects.end()) continue;
        search.PlaceClear(object, random);
      }
    }
    layout = search.layout();
    left = MakeExact(input, search.problem(), stage.objects, layout);
    if (!left.empty()) left = MakeExact(input, search.problem(), WithGroupsOf(input, left, stage.objects), layout);
  }
  if (!left.empty() && stage.objects.size() < whole.objects.size()) {
    left = MakeExact(input, search.problem(), whole.objects, layout);
  }
  SearchInput settle_input = search_input;
  settle_input.walk_grid = &input.fine_walk_grid.get();
  LayoutSearch settled(settle_input, search.problem(), layout);
  std::vector<std::vector<int>> members_of;
  for (int object : stage.objects) members_of.push_back(MembersOf(input, stage, object));
  settled.Settle(stage.objects, members_of);
  for (int object : stage.objects) Center(input, object, settled);
  double score = settled.Score();
  for (const Violation& violation : left) score += kInfeasible * (0.01 + violation.depth_m);
  search.set_layout(settled.layout());
  search.problem() = settled.problem();  // with its count of evaluations
  return score;
}

}  // namespace

RestartResult PolishRestart(const SolveInput& input, const StageSpec& stage, const PartialLayout& before, int restart,
                            int passes) {
  RestartResult result{restart, 0, 0, before};
  if (stage.objects.empty()) return result;
  Random random(RestartSeed(input.settings, stage, restart));
  const std::vector<int> held = InPattern(input, before);
  StageSpec free = stage;
  std::erase_if(free.objects, [&](int o) { return std::binary_search(held.begin(), held.end(), o); });
  for (int pass = 0; pass < passes; ++pass) {
    const std::vector<Vec2<double>> centers = ZoneCenters(input.scene, result.state.placed, result.state.layout);
    const SceneCosts costs = BindCosts(input, centers);
    const SearchInput search_input = SearchInputOf(input, centers, &input.walk_grid.get());
    LayoutSearch search(search_input, MakeProblem(input, costs, stage, result.state), result.state.layout);
    if (!input.OutOfTime() && !free.objects.empty()) Improve(input, free, search, random);
    if (pass + 1 == passes) result.score = Finish(input, stage, free, search_input, random, search);
    result.evaluations += search.evaluations();
    for (int object : stage.objects) result.state.Place(object, search.layout()[object]);
  }
  result.score += DisorderOf(input, result.state);
  return result;
}

RestartResult PolishHolding(const SolveInput& input, const PartialLayout& before, std::span<const int> held,
                            int restart) {
  const StageSpec whole = FreeStage(input, StageKind::kPolish);
  StageSpec rest = whole;
  std::erase_if(rest.objects, [&](int o) { return std::find(held.begin(), held.end(), o) != held.end(); });
  RestartResult result = PolishRestart(input, rest, before, restart);
  const std::vector<Vec2<double>> centers = ZoneCenters(input.scene, result.state.placed, result.state.layout);
  const SceneCosts costs = BindCosts(input, centers);
  const SearchInput search_input = SearchInputOf(input, centers, &input.fine_walk_grid.get());
  LayoutSearch search(search_input, MakeProblem(input, costs, whole, result.state), result.state.layout);
  Layout layout = search.layout();
  const std::vector<Violation> left = MakeExact(input, search.problem(), whole.objects, layout);
  search.set_layout(layout);
  result.score = search.Score();
  for (const Violation& violation : left) result.score += kInfeasible * (0.01 + violation.depth_m);
  result.evaluations += search.evaluations();
  for (int object : whole.objects) result.state.Place(object, layout[object]);
  return result;
}

}  // namespace flair::optimizer
