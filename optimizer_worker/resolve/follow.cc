// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/resolve/follow.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/stages/tertiary.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {
namespace {

// Nobody puts a lamp on top of a wardrobe.
constexpr double kReach_m = 1.3;

// What people sit or lie on, by the last word of its name or category.
constexpr std::array<std::string_view, 19> kSeats = {
    "armchair", "bed",     "bench", "chair",    "chaise", "couch", "crib",   "daybed", "futon", "hammock",
    "loveseat", "ottoman", "pouf",  "recliner", "rocker", "seat",  "settee", "sofa",   "stool"};

bool EndsInSeat(std::string_view text) {
  text = text.substr(0, text.find_last_not_of(" _0123456789") + 1);
  const std::string_view word = text.substr(text.find_last_of(" _") + 1);
  return std::find(kSeats.begin(), kSeats.end(), word) != kSeats.end();
}

bool IsSeat(const Object& object) { return EndsInSeat(object.name) || EndsInSeat(object.category); }

bool SameKind(const Object& a, const Object& b) {
  return a.name == b.name || (!a.category.empty() && a.category == b.category);
}

}  // namespace

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
  std::stable_sort(tops.begin(), tops.end(), [&](int a, int b) {
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
