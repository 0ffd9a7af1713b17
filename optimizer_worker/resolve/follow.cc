// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/resolve/follow.h"

#include <algorithm>

#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/stages/tertiary.h"
#include "room/geometry/angle.h"

namespace flair::optimizer {
namespace {

// Nobody puts a lamp on top of a wardrobe.
constexpr double kReach_m = 1.3;

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

void PutOnNearestTop(const SolveInput& input, int object, PartialLayout& state) {
  const Scene& scene = input.scene;
  const Footprint& footprint = scene.objects[object].footprint;
  const Vec2<double> from = Center(state.layout[object]);
  std::vector<int> tops;
  for (int i = 0; i < static_cast<int>(scene.objects.size()); ++i) {
    const Object& top = scene.objects[i];
    const bool holds = top.footprint.width_m >= footprint.width_m && top.footprint.depth_m >= footprint.depth_m;
    if (state.placed[i] && IsSolid(top) && holds && top.height_m <= kReach_m) tops.push_back(i);
  }
  std::stable_sort(tops.begin(), tops.end(), [&](int a, int b) {
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
