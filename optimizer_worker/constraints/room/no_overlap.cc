// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps two objects out of each other.
//   cost = max(-gap(A, B), 0)^2                                                                   [m2]
//   gap  signed gap of the two rectangles (measure/gap.h): minus the length of the shortest push that parts them
// Zero exactly when they are apart or touch; continuously differentiable at contact; pushes apart in the cheapest
// direction. The paper's Eq. no_overlap sums squared edge lengths of the intersection, which jumps from 0 to 10 at
// contact and has no usable slope (SEMANTICS.md section 5).
#include <fmt/format.h>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/gap.h"
#include "optimizer_worker/constraints/whole_room.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

namespace {

struct NoOverlap {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;
  Footprint first;
  Footprint second;
  // Their circles meet when the centres are closer than this.
  double reach_m = CircumscribedRadius(first) + CircumscribedRadius(second);

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const {
    // Most pairs are far apart: their circles do not meet.
    const double dx = ValueOf(frames[0].center.x) - ValueOf(frames[1].center.x);
    const double dy = ValueOf(frames[0].center.y) - ValueOf(frames[1].center.y);
    if (dx * dx + dy * dy >= reach_m * reach_m) return T(0.0);
    return SquaredPenetration<T>(Box<T>(first, frames[0]), Box<T>(second, frames[1]));
  }
};

}  // namespace

bool CanCollide(const Scene& scene, int a, int b) {
  const Object& first = scene.objects[static_cast<size_t>(a)];
  const Object& second = scene.objects[static_cast<size_t>(b)];
  if (a == b || first.walk_over || second.walk_over) return false;
  // Both stand on the floor, whatever is said about one carrying the other.
  if (first.kind == ObjectKind::kFloor && second.kind == ObjectKind::kFloor) return true;
  if (scene.Carries(a, b) || scene.Carries(b, a)) return false;
  const bool on_surface = first.kind == ObjectKind::kSurface || second.kind == ObjectKind::kSurface;
  const bool on_floor = first.kind == ObjectKind::kFloor || second.kind == ObjectKind::kFloor;
  // A thing on a table stays within the table, which keeps clear of other furniture.
  if (on_surface && on_floor) return false;
  // Small things whose carrier is not known yet could be anywhere.
  if (on_surface && first.kind == second.kind && first.host != second.host) return false;
  constexpr double kTouching_m = 0.01;
  return scene.BottomOf(a) < scene.TopOf(b) - kTouching_m && scene.BottomOf(b) < scene.TopOf(a) - kTouching_m;
}

std::unique_ptr<Cost> NoOverlapPair(const Scene& scene, int a, int b) {
  if (!CanCollide(scene, a, b)) return nullptr;
  return MakeCost(
      NoOverlap{scene.objects[static_cast<size_t>(a)].footprint, scene.objects[static_cast<size_t>(b)].footprint},
      {a, b});
}

ConstraintFacts NoOverlapFacts() {
  return {
      .name = "no_overlap",
      .family = "room",
      .summary = "`object` and `other` do not stand inside each other.",
      .doc =
          "cost = squared penetration depth [m2], the shortest push that parts the two rectangles, by separating axes. "
          "Rugs, carriers and things at other heights are exempt. The paper sums squared edge lengths of the "
          "intersection, which jumps at contact.",
      .parameters = {ObjectParameter("object", "The one."), ObjectParameter("other", "The other.")},
      .layouts = {Satisfied("5x4 room; a 1x1 at 1,1,0; b 1x1 at 2,1,0", "object=a other=b"),
                  Satisfied("5x4 room; a 1x1 at 1,1,0; b 1x1 at 2.3,1.1,45", "object=a other=b"),
                  Violated("5x4 room; a 1x1 at 1,1,0; b 1x1 at 1.9,1.2,0", "object=a other=b"),
                  Violated("5x4 room; a 2x0.4 at 1,1,30; b 1x1 at 1.4,1.2,70", "object=a other=b")},
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        std::unique_ptr<Cost> cost = NoOverlapPair(context.scene, a.Object("object"), a.Object("other"));
        if (cost != nullptr) return cost;
        return absl::FailedPreconditionError("these two cannot be in each other's way");
      },
      .built_in = true};
}

}  // namespace flair::optimizer
