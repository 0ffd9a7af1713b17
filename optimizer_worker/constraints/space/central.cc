// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps an object in the middle of the room.
//   cost = min(hx^2, hy^2), or hx^2 + hy^2 with both                                                         [m2]
//   hx, hy  distance of the centre outside the middle third of the room's bounding box, east-west and north-south
// Zero exactly when the centre is in the middle third along one axis (or both). The released ind_central multiplies hx
// and hy, so that it is flat along either third, and adds a heading term that whole-room alignment has already.
#include "optimizer_worker/autodiff/smooth.h"
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/polygon.h"

namespace flair::optimizer {

namespace {

struct Central {
  static constexpr int kObjects = 1;
  BoundingBox box;
  bool both;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const {
    const auto outside = [](const T& x, double low, double high) {
      return SquaredOutside(x, low + (high - low) / 3, high - (high - low) / 3);
    };
    const T across = outside(frames[0].center.x, box.min.x, box.max.x);
    const T along = outside(frames[0].center.y, box.min.y, box.max.y);
    if (both) return across + along;
    return across < along ? across : along;
  }
};

std::optional<Shortfall> CentralShortfall(const PlacedCall& call) {
  return Worst({OffBy(call.NameOf("object"), "the middle third of the room", call.CostRoot())});
}

}  // namespace

ConstraintFacts CentralFacts() {
  return {.name = "central",
          .aliases = {"ind_central", "io_central"},
          .family = "space",
          .summary = "The centre of `object` is in the middle third of the room, along one axis or along both.",
          .phrase = "stands in the middle third of the room",
          .doc =
              "cost = least (or sum, with both) of the squared distances outside the middle thirds [m2]. The released "
              "function "
              "multiplies them.",
          .parameters = {ObjectParameter("object", "What is central."),
                         FlagParameter("both", "Whether it is central along both axes.", false)},
          .sentences = {{"The dining table is in the centre of the room.", "object=table both=true"},
                        {"The rug is fairly central.", "object=rug"}},
          .layouts = {Satisfied("6x3 room; table 1x1 at 3.5,2.5,0", "object=table"),
                      Satisfied("6x3 room; table 1x1 at 3.5,1.9,0", "object=table both=true"),
                      Violated("6x3 room; table 1x1 at 3.5,2.5,0", "object=table both=true"),
                      Violated("6x3 room; table 1x1 at 1,2.3,0", "object=table")},
          .shortfall = CentralShortfall,
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            return MakeCost(Central{BoundsOf(context.scene.room.floor), a.Flag("both")}, {a.Object("object")});
          }};
}

}  // namespace flair::optimizer
