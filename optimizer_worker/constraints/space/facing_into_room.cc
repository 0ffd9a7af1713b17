// SPDX-License-Identifier: GPL-3.0-or-later
// Turns an object's front into the room.
//   cost = max(a - pi / 4, 0)^2                                                                              [rad2]
//   a  angle between its front and the direction from its centre to the room's centre
// Zero exactly when it faces the middle of the room within 45 degrees; any heading will do in the very middle. The
// released ind_facing_into_room is this with arccos without clipping, which scores 0 for many objects that are turned
// exactly away.
#include "optimizer_worker/autodiff/smooth.h"
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/pose.h"
#include "room/geometry/vec2.h"

namespace flair::optimizer {

namespace {

struct FacingIntoRoom {
  static constexpr int kObjects = 1;
  Vec2<double> room_center;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const {
    using std::atan2;
    const Vec2<T> to_center = Cast<T>(room_center) - frames[0].center;
    constexpr double kNoDirection_m2 = 1e-8;
    if (ValueOf(SquaredNorm(to_center)) < kNoDirection_m2) return T(0.0);
    const T angle = atan2(Magnitude(Cross(frames[0].front, to_center)), Dot(frames[0].front, to_center));
    return SquaredHinge(angle - kPi / 4);
  }
};

std::optional<Shortfall> FacingIntoRoomShortfall(const PlacedCall& call) {
  const Frame<double> frame = call.FrameOf(call.object());
  const Vec2<double> center = BoundsOf(call.scene().room.floor).Center();
  return Worst({Turned(SideOf(call.NameOf("object"), Side::kFront), "the middle of the room",
                       AngleOf(frame.front, center - frame.center), kPi / 4)});
}

}  // namespace

ConstraintFacts FacingIntoRoomFacts() {
  return {.name = "facing_into_room",
          .aliases = {"ind_facing_into_room", "io_facing_into_room"},
          .family = "space",
          .summary = "`object` faces the middle of the room, within 45 degrees.",
          .phrase = "faces into the room",
          .doc =
              "cost = max(angle between front and direction to the room's centre - pi / 4, 0)^2 [rad2]. As released, "
              "without "
              "its failure for objects turned exactly away.",
          .parameters = {ObjectParameter("object", "What faces the room.")},
          .sentences = {{"The sofa faces into the room.", "object=sofa"}},
          .layouts = {Satisfied("4x4 room; sofa 2x1 at 2,0.5,40", "object=sofa"),
                      Violated("4x4 room; sofa 2x1 at 2,0.5,60", "object=sofa"),
                      Violated("4x4 room; sofa 2x1 at 2.2,0.5,180", "object=sofa")},
          .shortfall = FacingIntoRoomShortfall,
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            return MakeCost(FacingIntoRoom{Centroid(context.scene.room.floor)}, {a.Object("object")});
          }};
}

}  // namespace flair::optimizer
