// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/tertiary.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "optimizer_worker/constraints/measure/hanging.h"
#include "optimizer_worker/constraints/whole_room.h"
#include "optimizer_worker/solver/separation.h"
#include "room/geometry/gap.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {
namespace {

constexpr int kSweeps = 3;
constexpr double kNoise = 0.05;
constexpr int kPushRounds = 60;
constexpr int kPartAttempts = 6;
constexpr double kMargin_m = 1e-7;
constexpr CandidateDensity kDense{.wall_samples = 12, .floor_samples = 24, .partner_samples = 2};

// The place along a wall nearest to `offset` where an object `2 * half` wide is off its openings; the nearest on the
// wall when there is none.
double FreeOffset(const HangingWall& place, double half, double offset) {
  const double low = half, high = std::max(half, place.wall.length_m - half);
  const auto is_free = [&](double at) {
    return at >= low - kMargin_m && at <= high + kMargin_m &&
           std::none_of(place.blocked.begin(), place.blocked.end(), [&](const HangingWall::Interval& b) {
             return at > b.start_m - half + kMargin_m && at < b.end_m + half - kMargin_m;
           });
  };
  const double wanted = std::clamp(offset, low, high);
  if (is_free(wanted)) return wanted;
  double best = wanted, least = std::numeric_limits<double>::infinity();
  for (const HangingWall::Interval& b : place.blocked) {
    for (double at : {b.start_m - half, b.end_m + half}) {
      if (!is_free(at) || std::abs(at - wanted) >= least) continue;
      least = std::abs(at - wanted);
      best = at;
    }
  }
  return best;
}

// Back exactly on the nearest wall that it is nearly parallel to, off its doors and windows.
void PutOnWall(const Scene& scene, int object, Pose<double>& pose) {
  const Footprint& footprint = scene.objects[object].footprint;
  const std::vector<HangingWall> places = HangingWalls(scene, object);
  const HangingWall* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const HangingWall& place : places) {
    const Wall& wall = place.wall;
    if (footprint.width_m > wall.length_m + 1e-9) continue;
    const double offset = wall.Offset(Center(pose));
    const double beyond = std::max({0.0, -offset, offset - wall.length_m});
    const double off = std::abs(wall.Height(Center(pose)) - footprint.depth_m / 2) + beyond +
                       AngleBetween(pose.theta_rad, wall.BackHeading());
    if (off >= least) continue;
    least = off;
    best = &place;
  }
  if (!best) return;
  const double offset = FreeOffset(*best, footprint.width_m / 2, best->wall.Offset(Center(pose)));
  const Vec2<double> p = best->wall.PointAt(offset) + (footprint.depth_m / 2) * best->wall.inward_normal;
  pose = {p.x, p.y, WrapHeading(best->wall.BackHeading())};
}

void PutInRoom(const KeepOut& keep_out, const Footprint& footprint, Pose<double>& pose) {
  for (int round = 0; round < 4; ++round) {
    bool moved = false;
    const auto move = [&](const Vec2<double>& direction, double by_m) {
      if (by_m <= 0) return;
      pose.x_m += by_m * direction.x;
      pose.y_m += by_m * direction.y;
      moved = true;
    };
    for (const FloorShape::HalfPlane& plane : keep_out.floor().half_planes()) {
      double outside = 0;
      for (const Vec2<double>& corner : Corners(footprint, pose)) {
        outside = std::max(outside, Dot(plane.normal, plane.point - corner));
      }
      move(plane.normal, outside);
    }
    // Where the room is not convex.
    for (const ConvexPiece& pocket : keep_out.floor().pockets()) {
      const Box<double> box(footprint, FrameOf(pose));
      const Witness w = SeparatingAxis(pocket, box);
      move(w.kind == Witness::kEdgeOfFirst ? pocket.normal(w.first) : -box.normal(w.second), -w.gap_m);
    }
    if (!moved) return;
  }
}

// Turned along the top's sides where it hangs over as it is and would not so.
void TurnToFit(const Footprint& top, const Pose<double>& host, const Footprint& footprint, Pose<double>& pose) {
  const auto hangs_over = [&](const Pose<double>& at) {
    const Vec2<double> front = FrameOf(host).ToObject(Center(host) + FrameOf(at).front);
    const double along = std::abs(front.x), across = std::abs(front.y);
    return std::max(across * footprint.width_m + along * footprint.depth_m - top.width_m,
                    along * footprint.width_m + across * footprint.depth_m - top.depth_m) > kMargin_m;
  };
  if (!hangs_over(pose)) return;
  const double quarter = kPi / 2;
  const double nearest = std::round((pose.theta_rad - host.theta_rad) / quarter);
  for (const double turns : {nearest, nearest + 1}) {
    const Pose<double> turned{pose.x_m, pose.y_m, WrapHeading(host.theta_rad + turns * quarter)};
    if (hangs_over(turned)) continue;
    pose = turned;
    return;
  }
}

void PutOnTop(const Footprint& top, const Pose<double>& host, const Footprint& footprint, Pose<double>& pose) {
  TurnToFit(top, host, footprint, pose);
  const Frame<double> frame = FrameOf(host);
  Vec2<double> local = frame.ToObject(Center(pose));
  double reach_u = 0, reach_v = 0;
  for (const Vec2<double>& corner : Corners(footprint, pose)) {
    const Vec2<double> c = frame.ToObject(corner) - local;
    reach_u = std::max(reach_u, std::abs(c.x));
    reach_v = std::max(reach_v, std::abs(c.y));
  }
  const double u = std::max(0.0, top.width_m / 2 - reach_u), v = std::max(0.0, top.depth_m / 2 - reach_v);
  local = {std::clamp(local.x, -u, u), std::clamp(local.y, -v, v)};
  const Vec2<double> p = frame.ToRoom(local.x, local.y);
  pose.x_m = p.x;
  pose.y_m = p.y;
}

// Puts an object exactly on its wall, on its `carrier` (-1 for none), in the room.
void Tidy(const SolveInput& input, int object, int carrier, PartialLayout& state) {
  const Object& what = input.scene.objects[object];
  Pose<double>& pose = state.layout[object];
  switch (what.kind) {
    case ObjectKind::kWall:
      return PutOnWall(input.scene, object, pose);
    case ObjectKind::kSurface: {
      if (carrier >= 0) {
        PutOnTop(input.scene.objects[carrier].footprint, state.layout[carrier], what.footprint, pose);
      }
      // A blanket that is larger than its sofa hangs over, but not through a wall.
      return PutInRoom(input.keep_out, what.footprint, pose);
    }
    case ObjectKind::kFloor:
    case ObjectKind::kCeiling:
      return PutInRoom(input.keep_out, what.footprint, pose);
  }
}

// The least move of `second` away from `first`; pieces on walls slide along theirs.
Vec2<double> PushOf(const Scene& scene, int first, int second, const Layout& layout) {
  const Box<double> a(scene.objects[first].footprint, FrameOf(layout[first]));
  const Box<double> b(scene.objects[second].footprint, FrameOf(layout[second]));
  const Separation apart = Separate(a, b);
  if (apart.gap_m >= 0) return {0, 0};
  if (scene.objects[second].kind != ObjectKind::kWall) return (kMargin_m - apart.gap_m) * apart.direction;
  const Vec2<double> along = FrameOf(layout[second]).right;
  double low = 1e9, high = -1e9, low_b = 1e9, high_b = -1e9;
  for (int i = 0; i < 4; ++i) {
    low = std::min(low, Dot(a.value(i), along));
    high = std::max(high, Dot(a.value(i), along));
    low_b = std::min(low_b, Dot(b.value(i), along));
    high_b = std::max(high_b, Dot(b.value(i), along));
  }
  const double forward = high - low_b + kMargin_m, backward = high_b - low + kMargin_m;
  return forward < backward ? forward * along : (-backward) * along;
}

// What fits on a top, or hangs over it as a cloth does.
bool Rests(const Scene& scene, int object, int carrier) {
  return IsFlat(scene.objects[object]) || FitsOn(scene, object, carrier);
}

// A thick blanket that is larger than its chair may slide off it, nothing else may.
int CarrierNow(const SolveInput& input, int object, int carrier, const PartialLayout& state) {
  if (carrier < 0 || Rests(input.scene, object, carrier)) return carrier;
  return CarrierOf(input.scene, object, state);
}

// Parts pieces that still overlap by a little, each pair in halves, keeping them on their tops, walls and in the room.
void PushApart(const SolveInput& input, const StageSpec& stage, const std::vector<int>& carriers,
               PartialLayout& state) {
  for (int round = 0; round < kPushRounds; ++round) {
    bool moved = false;
    for (size_t i = 0; i < stage.objects.size(); ++i) {
      for (size_t j = 0; j < i; ++j) {
        const int a = stage.objects[j], b = stage.objects[i];
        if (!CanCollide(input.scene, a, b)) continue;
        const Vec2<double> push = PushOf(input.scene, a, b, state.layout);
        if (push.x == 0 && push.y == 0) continue;
        moved = true;
        state.layout[a].x_m -= push.x / 2;
        state.layout[a].y_m -= push.y / 2;
        state.layout[b].x_m += push.x / 2;
        state.layout[b].y_m += push.y / 2;
        Tidy(input, a, CarrierNow(input, a, carriers[j], state), state);
        Tidy(input, b, CarrierNow(input, b, carriers[i], state), state);
      }
    }
    if (!moved) return;
  }
}

// Pieces that are in each other's way are taken out and placed anew together, in another order each time.
void PartByReplacing(const SolveInput& input, const StageSpec& stage, LayoutSearch& search, Random& random) {
  for (int attempt = 0; attempt < kPartAttempts; ++attempt) {
    std::vector<int> overlapping;
    for (int object : stage.objects) {
      const bool in_the_way = std::any_of(stage.objects.begin(), stage.objects.end(), [&](int other) {
        if (!CanCollide(input.scene, object, other)) return false;
        const Vec2<double> push = PushOf(input.scene, object, other, search.layout());
        return push.x != 0 || push.y != 0;
      });
      if (in_the_way) overlapping.push_back(object);
    }
    if (overlapping.empty()) return;
    for (size_t i = overlapping.size() - 1; i > 0; --i) {
      std::swap(overlapping[i], overlapping[static_cast<size_t>(random.Below(static_cast<int>(i) + 1))]);
    }
    search.Replace(overlapping, attempt == 0 ? 0.0 : kNoise, random);
  }
}

// SLSQP for one piece; kept only when it helps. Wall pieces slide along their wall in the sweeps instead.
void DescendEach(const SolveInput& input, const StageSpec& stage, LayoutSearch& search) {
  for (int object : stage.objects) {
    if (input.scene.objects[object].kind == ObjectKind::kWall) continue;
    const Layout before = search.layout();
    const double cost = search.problem().Around(object, before, std::numeric_limits<double>::infinity());
    if (cost < 1e-6) continue;
    const int one[] = {object};
    search.Descend(one, {.max_evaluations = 30, .relative_tolerance = 1e-3, .absolute_tolerance = 1e-5});
    Layout snapped = search.layout();
    const double quarter = kPi / 2;
    double& theta = snapped[object].theta_rad;
    if (std::abs(theta - std::round(theta / quarter) * quarter) < 0.05) theta = std::round(theta / quarter) * quarter;
    search.set_layout(snapped);
    if (search.problem().Around(object, snapped, cost) >= cost) search.set_layout(before);
  }
}

// Per object of the stage.
std::vector<int> CarriersOf(const SolveInput& input, const StageSpec& stage, const Layout& layout,
                            PartialLayout state) {
  for (int object : stage.objects) state.Place(object, layout[object]);
  std::vector<int> carriers;
  for (int object : stage.objects) {
    const bool stands = input.scene.objects[object].kind == ObjectKind::kSurface;
    carriers.push_back(stands ? CarrierOf(input.scene, object, state) : -1);
  }
  return carriers;
}

// Neighbours may have pushed an object off what it was put on: it goes back, unless it stands on what it belongs to.
int CarrierToKeep(const SolveInput& input, int object, int meant, int now) {
  if (now < 0 && meant < 0 && IsFlat(input.scene.objects[object])) {
    // A cloth that made way for what lies on it.
    const auto solid = [&](int partner) { return IsSolid(input.scene.objects[partner]); };
    const auto top = std::ranges::find_if(input.partners[object], solid);
    return top == input.partners[object].end() ? -1 : *top;
  }
  if (meant < 0 || !Rests(input.scene, object, meant)) return now;
  const auto belongs = [&](int carrier) {
    const std::vector<int>& partners = input.partners[object];
    return std::find(partners.begin(), partners.end(), carrier) != partners.end();
  };
  return now < 0 || (belongs(meant) && !belongs(now)) ? meant : now;
}

}  // namespace

bool FitsOn(const Scene& scene, int object, int carrier) {
  const Footprint& thing = scene.objects[object].footprint;
  const Footprint& top = scene.objects[carrier].footprint;
  return std::max(thing.width_m, thing.depth_m) <= std::max(top.width_m, top.depth_m) &&
         std::min(thing.width_m, thing.depth_m) <= std::min(top.width_m, top.depth_m);
}

RestartResult TertiaryRestart(const SolveInput& input, const StageSpec& stage, const PartialLayout& before,
                              int restart) {
  RestartResult result{restart, 0, 0, before};
  if (stage.objects.empty()) return result;
  Random random(RestartSeed(input.settings, stage, restart));
  const std::vector<Vec2<double>> centers = ZoneCenters(input.scene, before.placed, before.layout);
  const SceneCosts costs = BindCosts(input, centers);
  const SearchInput search_input = SearchInputOf(input, centers, nullptr);
  LayoutSearch search(search_input, MakeProblem(input, costs, stage, before), before.layout);
  search.Construct(stage.objects, restart == 0 ? 0.0 : kNoise, random);
  const std::vector<int> meant = CarriersOf(input, stage, search.layout(), before);
  search.Sweep(stage.objects, kSweeps, kDense, random);
  PartByReplacing(input, stage, search, random);
  DescendEach(input, stage, search);
  for (int object : stage.objects) result.state.Place(object, search.layout()[object]);
  std::vector<int> carriers = CarriersOf(input, stage, search.layout(), before);
  for (size_t i = 0; i < carriers.size(); ++i) {
    carriers[i] = CarrierToKeep(input, stage.objects[i], meant[i], carriers[i]);
    Tidy(input, stage.objects[i], carriers[i], result.state);
  }
  PushApart(input, stage, carriers, result.state);
  SeparateClusters(input, stage, search.problem(), result.state);
  search.set_layout(result.state.layout);
  result.score = search.Cost();
  result.evaluations = search.evaluations();
  return result;
}

}  // namespace flair::optimizer
