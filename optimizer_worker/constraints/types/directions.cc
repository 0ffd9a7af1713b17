// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "room/autodiff/dual.h"
#include "room/geometry/polygon.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {
namespace {

// Turns an object towards another.
//   cost = (|FL - c| - |BL - c|)+^2 + (|FR - c| - |BR - c|)+^2 + (d_left + d_right - w)^2                      [m2]
//   c                 centre of the target;  FL, BL, FR, BR  front and back corners of the object
//   d_left, d_right   distances of c from the lines through its left and right side, w its width
// With both, the same with roles swapped and (f1 . f2 + 1)^2. Zero exactly when the target's centre is ahead within the
// strip of the object's width (with both: facing each other). As the released io_facing.

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

// How an object, or its user, misses looking at another: out of its strip, or behind.
Shortfall NotFaced(const PlacedCall& call, int object, int target, Look look = Look::kOwn) {
  const Frame<double> frame = LookOf(call.FrameOf(object), look);
  const Vec2<double> p = frame.ToObject(call.FrameOf(target).center);
  const double aside = std::abs(p.x) - call.FootprintOf(object).width_m / 2;
  if (p.y >= 0 && aside > 0) {
    const std::string who = look == Look::kOwn ? call.Name(object) : WhoLooks(call, object, look);
    return {fmt::format("{} is {:.2f} m to the side of where {} looks", call.Name(target), aside, who), aside, "m"};
  }
  return Turned(WhoLooks(call, object, look), call.Name(target),
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

BoundCost BindFacing(const Arguments& a, const BindContext& context) {
  const int object = a.Object("object"), target = a.Object("target");
  const auto formula = [first = FootprintOf(context, object), second = FootprintOf(context, target),
                        both = a.Flag("both")]<typename T>(const Frames<T, 2>& frames) {
    const T one_way = Faces(first, frames[0], frames[1].center);
    if (!both) return one_way;
    return one_way + Faces(second, frames[1], frames[0].center) + Square(Dot(frames[0].front, frames[1].front) + 1.0);
  };
  return MakeCost<kOnlyRelative>({object, target}, formula);
}

// The same of its user, and of no other.
std::optional<Shortfall> UserFacesShortfall(const PlacedCall& call) {
  return Worst({NotFaced(call, call.object(), call.target(), Look::kOfUser)});
}

BoundCost BindUserFaces(const Arguments& a, const BindContext& context) {
  const int object = a.Object("object"), target = a.Object("target");
  const auto formula = [own = FootprintOf(context, object)]<typename T>(const Frames<T, 2>& frames) {
    return Faces(own, LookOf(frames[0], Look::kOfUser), frames[1].center);
  };
  return MakeCost<kOnlyRelative>({object, target}, formula);
}

// Turns an object away from another: cost = max(cos a - cos 45, 0)^2, a the angle between its front and the direction
// from its centre to the target's. Zero exactly when the target is at least 45 degrees off its look. The released
// io_not_facing is identically zero (SEMANTICS.md section 4).
template <Look kLook>
std::optional<Shortfall> NotFacingShortfall(const PlacedCall& call) {
  const Frame<double> frame = LookOf(call.FrameOf(call.object()), kLook);
  const double angle = AngleOf(frame.front, call.FrameOf(call.target()).center - frame.center);
  const double missed_deg = 45 - angle * 180 / kPi;
  const std::string who = kLook == Look::kOwn ? call.NameOf("object") : WhoLooks(call, call.object(), kLook);
  return Worst(
      {{fmt::format("{} looks within {:.0f} degrees of {}, at least 45", who, angle * 180 / kPi, call.NameOf("target")),
        missed_deg, "deg"}});
}

template <Look kLook>
BoundCost BindNotFacing(const Arguments& a, const BindContext&) {
  const auto formula = []<typename T>(const Frames<T, 2>& frames) {
    constexpr double kCos45 = 0.70710678118654757;
    const Vec2<T> to_target = frames[1].center - frames[0].center;
    constexpr double kNoDirection_m2 = 1e-8;
    if (ValueOf(SquaredNorm(to_target)) < kNoDirection_m2) return T(0.0);
    return SquaredHinge(Dot(LookOf(frames[0], kLook).front, to_target) / Length(to_target) - kCos45);
  };
  return MakeCost<kOnlyRelative>({a.Object("object"), a.Object("target")}, formula);
}

// Gives two objects the same heading: cost = 1 - cos(theta_1 - theta_2). Zero exactly when both face the same way. The
// released io_parallel squares the difference of headings reduced to [0, 2 pi), which jumps by 39 at the wrap
// (SEMANTICS.md section 4).
std::optional<Shortfall> ParallelShortfall(const PlacedCall& call) {
  return Worst({Turned(call.NameOf("object"), "the direction of " + call.NameOf("target"),
                       AngleOf(call.FrameOf(call.object()).front, call.FrameOf(call.target()).front))});
}

BoundCost BindParallel(const Arguments& a, const BindContext&) {
  return MakeCost<kOnlyRelative>({a.Object("object"), a.Object("target")}, []<typename T>(const Frames<T, 2>& frames) {
    return Turn(frames[0].front, frames[1].front);
  });
}

// Stands two objects at a right angle, with a third object before both when one is named.
//   cost = (f1 . f2)^2 + sum over both of  max(|u_i| - w_i / 4, 0)^2 + max(-v_i, 0)^2                          [m2]
//   f1, f2    front directions;  u_i, v_i  how far right and ahead of object i the centre object is;  w_i  its width
// The sum is there with `center` only. Zero exactly when they stand at a right angle and the centre object is ahead of
// the middle half of both. The released io_perp drops object 0, reads the pose of another object and divides by zero
// for parallel ones (SEMANTICS.md section 4).
template <typename T>
T Before(const Footprint& footprint, const Frame<T>& frame, const Vec2<T>& point) {
  const Vec2<T> p = frame.ToObject(point);
  return SquaredOutside(p.x, -footprint.width_m / 4, footprint.width_m / 4) + SquaredHinge(-p.y);
}

std::optional<Shortfall> PerpendicularShortfall(const PlacedCall& call) {
  const double angle = AngleOf(call.FrameOf(call.object()).front, call.FrameOf(call.target()).front);
  std::vector<Shortfall> misses = {
      Turned(call.NameOf("object"), "a right angle to " + call.NameOf("target"), std::abs(angle - kPi / 2))};
  if (call.arguments().Has("center")) {
    misses.push_back(OffBy(call.NameOf("object") + " or " + call.NameOf("target"),
                           "where it would face " + call.Name(call.arguments().MaybeObject("center")),
                           call.CostRoot()));
  }
  return Worst(misses);
}

BoundCost BindPerpendicular(const Arguments& a, const BindContext& context) {
  const int object = a.Object("object"), target = a.Object("target");
  const int center = a.MaybeObject("center");
  const auto right_angle = []<typename T>(const Frames<T, 2>& frames) {
    return Square(Dot(frames[0].front, frames[1].front));
  };
  if (center < 0) return MakeCost<kOnlyRelative>({object, target}, right_angle);
  const auto formula = [right_angle, first = FootprintOf(context, object),
                        second = FootprintOf(context, target)]<typename T>(const Frames<T, 3>& frames) {
    return right_angle(Frames<T, 2>{frames[0], frames[1]}) + Before(first, frames[0], frames[2].center) +
           Before(second, frames[1], frames[2].center);
  };
  return MakeCost<kOnlyRelative>({object, target, center}, formula);
}

constexpr ConstraintCode kDirectionsCode[] = {
    {"facing", BindFacing, FacingShortfall},
    {"not_facing", BindNotFacing<Look::kOwn>, NotFacingShortfall<Look::kOwn>},
    {"parallel", BindParallel, ParallelShortfall},
    {"perpendicular", BindPerpendicular, PerpendicularShortfall},
    {"user_faces", BindUserFaces, UserFacesShortfall},
    {"user_not_facing", BindNotFacing<Look::kOfUser>, NotFacingShortfall<Look::kOfUser>},
};

}  // namespace

std::span<const ConstraintCode> DirectionsCode() { return kDirectionsCode; }

}  // namespace flair::optimizer
