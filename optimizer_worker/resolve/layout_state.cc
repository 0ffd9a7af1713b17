// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "evaluation/metrics/walk_grid.h"
#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/resolve/warm_search.h"
#include "optimizer_worker/stages/floor_stages.h"
#include "optimizer_worker/stages/infeasible.h"
#include "optimizer_worker/stages/solved_layout.h"
#include "optimizer_worker/stages/tertiary.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {
namespace {

void AddOnce(std::vector<int>& list, int value) {
  const auto place = std::ranges::lower_bound(list, value);
  if (place == list.end() || *place != value) list.insert(place, value);
}

bool Satisfied(const Term& term, const PartialLayout& state) {
  std::vector<Pose<double>> poses;
  for (int object : term.cost->objects()) poses.push_back(state.layout[object]);
  return term.cost->Value(poses) <= kSatisfiedCost;
}

// Nobody puts a lamp on top of a wardrobe.
constexpr double kReach_m = 1.3;

// What people sit or lie on, by the last word of its name or category.
constexpr std::array<std::string_view, 19> kSeats = {
    "armchair", "bed",     "bench", "chair",    "chaise", "couch", "crib",   "daybed", "futon", "hammock",
    "loveseat", "ottoman", "pouf",  "recliner", "rocker", "seat",  "settee", "sofa",   "stool"};

bool EndsInSeat(std::string_view text) {
  text = text.substr(0, text.find_last_not_of(" _0123456789") + 1);
  const std::string_view word = text.substr(text.find_last_of(" _") + 1);
  return std::ranges::find(kSeats, word) != kSeats.end();
}

bool IsSeat(const Object& object) { return EndsInSeat(object.name) || EndsInSeat(object.category); }

bool SameKind(const Object& a, const Object& b) {
  return a.name == b.name || (!a.category.empty() && a.category == b.category);
}

}  // namespace

Violations FindViolations(const SolveInput& input, const PartialLayout& state, const Baseline& baseline) {
  Violations violations;
  const auto solid = [&](int object) { return object < 0 || IsSolid(input.scene.objects[object]); };
  const SceneCosts costs = BindCosts(input, state);
  for (const Misfit& misfit : FindMisfits(input, costs, state)) {
    if (baseline.tolerated.contains({misfit.object, misfit.other})) continue;
    // Where the user has put things into each other or through a wall, nobody can help.
    if (input.pinned[misfit.object] && (misfit.other < 0 || input.pinned[misfit.other])) continue;
    const bool on_floor = solid(misfit.object) && solid(misfit.other);
    if (on_floor) violations.depth_m += misfit.depth_m;
    for (int object : {misfit.object, misfit.other}) {
      if (object < 0 || input.pinned[object]) continue;
      if (on_floor) AddOnce(violations.colliding, object);
      // Where something on a wall meets something on the floor, the first gives way.
      if (!solid(object)) AddOnce(violations.astray, object);
    }
  }
  for (const Term& term : costs.terms) {
    if (term.edge < 0 || !baseline.held[term.edge]) continue;
    const bool there = std::ranges::all_of(term.required, [&](int object) { return state.placed[object] != 0; });
    if (there && !Satisfied(term, state)) violations.broken.push_back(term.edge);
  }
  constexpr double kStep = 0.05;
  const double lost = baseline.reachable_share > 0 ? baseline.reachable_share - ReachableShare(input, state) : 0;
  violations.unreachable_share = kStep * std::max(0.0, std::floor(lost / kStep));
  return violations;
}

double ReachableShare(const SolveInput& input, const PartialLayout& state) {
  std::vector<evaluation::Obstacle> obstacles;
  for (size_t i = 0; i < input.scene.objects.size(); ++i) {
    const Object& object = input.scene.objects[i];
    if (state.placed[i] && IsSolid(object)) obstacles.push_back({state.layout[i], object.footprint});
  }
  evaluation::WalkGrid grid = input.walk_grid.get();
  return grid.Measure(obstacles).reachable_share;
}

std::set<std::pair<int, int>> PairsInTheWay(const SolveInput& input, const PartialLayout& state) {
  std::set<std::pair<int, int>> pairs;
  for (const Misfit& misfit : FindMisfits(input, BindCosts(input, state), state)) {
    pairs.emplace(misfit.object, misfit.other);
  }
  return pairs;
}

double ScoreOf(const SolveInput& input, const StageSpec& stage, const PartialLayout& state) {
  const bool floor = stage.kind != StageKind::kTertiary;
  const std::vector<Vec2<double>> centers = ZoneCenters(input.scene, state.placed, state.layout);
  const SceneCosts costs = BindCosts(input, centers);
  const SearchInput search_input = SearchInputOf(input, centers, floor ? &input.walk_grid.get() : nullptr);
  LayoutSearch search(search_input, MakeProblem(input, costs, stage, state), state.layout);
  double score = search.Score();
  if (!floor) return score;
  std::vector<int> standing;
  for (int i = 0; i < static_cast<int>(input.scene.objects.size()); ++i) {
    if (state.placed[i]) standing.push_back(i);
  }
  for (const Violation& violation : FindViolations(input.scene, input.keep_out, standing, state.layout, kTouching_m)) {
    score += kInfeasible * (0.01 + violation.depth_m);
  }
  return score;
}

Pose<double> Carried(const Pose<double>& carrier_before, const Pose<double>& carrier_after, const Pose<double>& rider) {
  const Vec2<double> local = FrameOf(carrier_before).ToObject(Center(rider));
  const Vec2<double> p = FrameOf(carrier_after).ToRoom(local.x, local.y);
  return {p.x, p.y, WrapHeading(rider.theta_rad + carrier_after.theta_rad - carrier_before.theta_rad)};
}

void Follow(const SolveInput& input, const PartialLayout& before, std::span<const int> movers, PartialLayout& after) {
  std::vector<char> settled(input.scene.objects.size(), 0);
  std::vector<int> queue;
  for (int mover : movers) {
    settled[mover] = 1;
    if (before.placed[mover] && after.placed[mover] && !(before.layout[mover] == after.layout[mover])) {
      queue.push_back(mover);
    }
  }
  for (size_t next = 0; next < queue.size(); ++next) {
    const int carrier = queue[next];
    for (int i = 0; i < static_cast<int>(input.scene.objects.size()); ++i) {
      if (settled[i] || input.pinned[i] || input.scene.objects[i].kind != ObjectKind::kSurface) continue;
      if (!before.placed[i] || !after.placed[i] || CarrierOf(input.scene, i, before) != carrier) continue;
      after.layout[i] = Carried(before.layout[carrier], after.layout[carrier], before.layout[i]);
      settled[i] = 1;
      queue.push_back(i);
    }
  }
}

void PutOnLikeTop(const SolveInput& input, int object, const Object* lost, PartialLayout& state) {
  const Scene& scene = input.scene;
  const Footprint& footprint = scene.objects[object].footprint;
  const Vec2<double> from = Center(state.layout[object]);
  std::vector<int> tops;
  for (int i = 0; i < static_cast<int>(scene.objects.size()); ++i) {
    const Object& top = scene.objects[i];
    const bool holds = top.footprint.width_m >= footprint.width_m && top.footprint.depth_m >= footprint.depth_m;
    const bool same = lost != nullptr && SameKind(top, *lost);
    const bool like = same || ((lost == nullptr || IsSeat(top) == IsSeat(*lost)) && top.height_m <= kReach_m);
    if (state.placed[i] && IsSolid(top) && holds && like) tops.push_back(i);
  }
  std::ranges::stable_sort(tops, [&](int a, int b) {
    const bool same_a = lost != nullptr && SameKind(scene.objects[a], *lost);
    const bool same_b = lost != nullptr && SameKind(scene.objects[b], *lost);
    if (same_a != same_b) return same_a;
    return Distance(Center(state.layout[a]), from) < Distance(Center(state.layout[b]), from);
  });
  const auto free = [&](const Pose<double>& pose) {
    const Box<double> box(footprint, FrameOf(pose));
    for (int i = 0; i < static_cast<int>(scene.objects.size()); ++i) {
      if (i == object || !state.placed[i] || scene.objects[i].kind != ObjectKind::kSurface) continue;
      if (Separate(Box<double>(scene.objects[i].footprint, FrameOf(state.layout[i])), box).gap_m < 0) return false;
    }
    return true;
  };
  for (int top : tops) {
    const double u = (scene.objects[top].footprint.width_m - footprint.width_m) / 2;
    for (double along : {0.0, -u, u}) {
      const Vec2<double> p = FrameOf(state.layout[top]).ToRoom(along, 0);
      const Pose<double> pose{p.x, p.y, state.layout[top].theta_rad};
      if (free(pose)) return state.Place(object, pose);
    }
  }
  state.placed[object] = 0;
  state.layout[object] = FarAway(object);
}

std::vector<int> ObjectsOfEdge(const SolveInput& input, int edge) {
  return NamedObjects(input.graph.edges(edge), input.scene);
}

}  // namespace flair::optimizer
