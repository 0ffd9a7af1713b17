// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/resolve/follow.h"

#include <algorithm>

#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/stages/tertiary.h"
#include "room/geometry/angle.h"

namespace flair::optimizer {
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

std::vector<int> ObjectsOfEdge(const SolveInput& input, int edge) {
  return NamedObjects(input.graph.edges(edge), input.scene);
}

}  // namespace flair::optimizer
