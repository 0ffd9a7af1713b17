// SPDX-License-Identifier: GPL-3.0-or-later
// Turns an object towards another.
//   cost = (|FL - c| - |BL - c|)+^2 + (|FR - c| - |BR - c|)+^2 + (d_left + d_right - w)^2                      [m2]
//   c                 centre of the target;  FL, BL, FR, BR  front and back corners of the object
//   d_left, d_right   distances of c from the lines through its left and right side, w its width
// With both, the same with roles swapped and (f1 . f2 + 1)^2. Zero exactly when the target's centre is ahead within the
// strip of the object's width (with both: facing each other). As the released io_facing.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "optimizer_worker/autodiff/smooth.h"
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/footprint.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {

namespace {

template <typename T>
T Faces(const Footprint& footprint, const Frame<T>& frame, const Vec2<T>& point) {
  const Vec2<T> p = frame.ToObject(point);
  T sum(0.0);
  // Behind: only then the front corners are further away than the back ones.
  if (ValueOf(p.y) < 0) {
    const std::array<Vec2<T>, 4> c = Corners(footprint, frame);
    sum += SquaredHinge(Length(c[3] - point) - Length(c[0] - point)) +
           SquaredHinge(Length(c[2] - point) - Length(c[1] - point));
  }
  // The two distances sum to the width within the strip and to twice the lateral offset beyond it.
  return sum + SquaredHinge(2.0 * Magnitude(p.x) - footprint.width_m);
}

struct Facing {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;
  Footprint object;
  Footprint target;
  bool both;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const {
    const T one_way = Faces(object, frames[0], frames[1].center);
    if (!both) return one_way;
    return one_way + Faces(target, frames[1], frames[0].center) + Square(Dot(frames[0].front, frames[1].front) + 1.0);
  }
};

// How an object misses looking at another: out of its strip, or behind.
Shortfall NotFaced(const PlacedCall& call, int object, int target) {
  const Frame<double> frame = call.FrameOf(object);
  const Vec2<double> p = frame.ToObject(call.FrameOf(target).center);
  const double aside = std::abs(p.x) - call.FootprintOf(object).width_m / 2;
  if (p.y >= 0 && aside > 0) {
    return {fmt::format("{} is {:.2f} m to the side of where {} looks", call.Name(target), aside, call.Name(object)),
            aside, "m"};
  }
  return Turned(SideOf(call.Name(object), Side::kFront), call.Name(target),
                p.y >= 0 ? 0 : AngleOf(frame.front, call.FrameOf(target).center - frame.center));
}

std::optional<Shortfall> FacingShortfall(const PlacedCall& call) {
  const int object = call.object(), target = call.target();
  std::vector<Shortfall> misses = {NotFaced(call, object, target)};
  if (call.arguments().Flag("both")) {
    misses.push_back(NotFaced(call, target, object));
    misses.push_back(Turned(call.Name(object), fmt::format("facing {} squarely", call.Name(target)),
                            kPi - AngleOf(call.FrameOf(object).front, call.FrameOf(target).front)));
  }
  return Worst(misses);
}

}  // namespace

ConstraintFacts FacingFacts() {
  return {
      .name = "facing",
      .aliases = {"io_facing", "p_facing", "ind_facing"},
      .family = "pair",
      .summary = "`object` faces `target`: the target's centre is straight ahead of it, within its width.",
      .phrase = "faces {target}",
      .doc =
          "cost = squared differences of corner distances when the target is behind + squared lateral excess of its "
          "centre over the strip of the object's width [m2]; with both also the other way and opposed headings. As "
          "released.",
      .parameters = {ObjectParameter("object", "What faces."), ObjectParameter("target", "What is faced."),
                     FlagParameter("both", "Whether they face each other.", false)},
      .sentences = {{"The sofa faces the television.", "object=sofa target=tv"},
                    {"The two armchairs face each other.", "object=chair_1 target=chair_2 both=true"}},
      .layouts = {Satisfied("5x4 room; a 2x1 at 2,1,0; b 1x1 at 2.9,3,30", "object=a target=b"),
                  Satisfied("5x4 room; a 2x1 at 2,1,0; b 1x1 at 2,3,180", "object=a target=b both=true"),
                  Violated("5x4 room; a 2x1 at 2,1,20; b 1x1 at 3.8,3,30", "object=a target=b"),
                  Violated("5x4 room; a 2x1 at 2,3,10; b 1x1 at 2.3,1,30", "object=a target=b"),
                  Violated("5x4 room; a 2x1 at 2,1,0; b 1x1 at 2,3,100", "object=a target=b both=true")},
      .shortfall = FacingShortfall,
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        const int object = a.Object("object");
        const int target = a.Object("target");
        return MakeCost(Facing{FootprintOf(context, object), FootprintOf(context, target), a.Flag("both")},
                        {object, target});
      }};
}

}  // namespace flair::optimizer
