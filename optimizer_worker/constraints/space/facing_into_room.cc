// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/space/facing_into_room.h"

#include "optimizer_worker/autodiff/smooth.h"
#include "optimizer_worker/constraints/facts.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {

template <typename T>
T FacingIntoRoom::operator()(const Frames<T, 1>& frames) const {
  using std::atan2;
  const Vec2<T> to_center = Cast<T>(room_center) - frames[0].center;
  constexpr double kNoDirection_m2 = 1e-8;
  if (ValueOf(SquaredNorm(to_center)) < kNoDirection_m2) return T(0.0);
  const T angle = atan2(Magnitude(Cross(frames[0].front, to_center)), Dot(frames[0].front, to_center));
  return SquaredHinge(angle - kPi / 4);
}

ConstraintFacts FacingIntoRoomFacts() {
  return {.name = "facing_into_room",
          .aliases = {"ind_facing_into_room", "io_facing_into_room"},
          .family = "space",
          .summary = "`object` faces the middle of the room, within 45 degrees.",
          .doc =
              "cost = max(angle between front and direction to the room's centre - pi / 4, 0)^2 [rad2]. As released, "
              "without "
              "its failure for objects turned exactly away.",
          .parameters = {ObjectParameter("object", "What faces the room.")},
          .sentences = {{"The sofa faces into the room.", "object=sofa"}},
          .layouts = {Satisfied("4x4 room; sofa 2x1 at 2,0.5,40", "object=sofa"),
                      Violated("4x4 room; sofa 2x1 at 2,0.5,60", "object=sofa"),
                      Violated("4x4 room; sofa 2x1 at 2.2,0.5,180", "object=sofa")},
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            return MakeCost(FacingIntoRoom{Centroid(context.scene.room.floor)}, {a.Object("object")});
          }};
}

}  // namespace flair::optimizer
