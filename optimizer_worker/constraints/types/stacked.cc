// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/walls.h"
#include "room/autodiff/dual.h"
#include "room/geometry/polygon.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {
namespace {

// cost = |c1 - c2|^2 [m2]. Zero exactly when the centres meet.
std::unique_ptr<Cost> CentersMeet(int first, int second) {
  return MakeCost<kOnlyRelative>({first, second}, []<typename T>(const Frames<T, 2>& frames) {
    return SquaredNorm(frames[0].center - frames[1].center);
  });
}

// Hangs an object above another: their centres meet, as the released ceiling_above.
std::optional<Shortfall> CeilingAboveShortfall(const PlacedCall& call) {
  return OffMiddle(call, call.object(), call.target());
}

BoundCost BindCeilingAbove(const Arguments& a, const BindContext&) {
  return CentersMeet(a.Object("object"), a.Object("target"));
}

// Hangs an object from the middle of the ceiling: cost = |c - c_room|^2 [m2], as the released center_ceiling. The
// room's centre is its centre of mass. Zero exactly there.
BoundCost BindCeilingCenter(const Arguments& a, const BindContext& context) {
  return MakeCost({a.Object("object")},
                  [room_center = Centroid(context.scene.room.floor)]<typename T>(const Frames<T, 1>& frames) {
                    return SquaredNorm(frames[0].center - Cast<T>(room_center));
                  });
}

// Keeps an object wholly on another, seen from above.
//   cost = sum over corners of max(|u| - w / 2, 0)^2 + max(|v| - d / 2, 0)^2                                   [m2]
//   u, v  the object's corners in the target's frame;  w, d  the target's width and depth
// Zero exactly when no corner sticks out. The released io_on sums edges of the intersection, so that less contact costs
// less (SEMANTICS.md section 4).
std::optional<Shortfall> OnShortfall(const PlacedCall& call) {
  const double out = call.CostRoot();
  return Worst(
      {{fmt::format("{} sticks {:.2f} m out over {}", call.NameOf("object"), out, call.NameOf("target")), out, "m"}});
}

BoundCost BindOn(const Arguments& a, const BindContext& context) {
  const int object = a.Object("object"), target = a.Object("target");
  return MakeCost<kOnlyRelative | kSeesZero>(
      {object, target},
      [first = FootprintOf(context, object), second = FootprintOf(context, target)]<typename T>(
          const Frames<T, 2>& frames) { return SquaredSticksOut(first, frames[0], second, frames[1]); });
}

// Sets a thing on the middle of another: cost = |c1 - c2|^2 + (1 - cos(theta_1 - theta_2)) [m2]. Zero exactly when the
// centres meet and both face the same way. The released on_top_central compares headings that wrap.
std::optional<Shortfall> OnTopCenterShortfall(const PlacedCall& call) {
  const int object = call.object(), host = call.arguments().Object("host");
  if (const std::optional<Shortfall> off = OffMiddle(call, object, host)) return off;
  return Worst({Turned(call.Name(object), "the direction of " + call.Name(host),
                       AngleOf(call.FrameOf(object).front, call.FrameOf(host).front))});
}

BoundCost BindOnTopCenter(const Arguments& a, const BindContext&) {
  return MakeCost<kOnlyRelative>({a.Object("object"), a.Object("host")}, []<typename T>(const Frames<T, 2>& frames) {
    return SquaredNorm(frames[0].center - frames[1].center) + Turn(frames[0].front, frames[1].front);
  });
}

// Sets a thing on one corner of another.
//   cost = overhang^2 + max(p_u - s_u u, 0)^2 + max(p_v - s_v v, 0)^2 + (1 - cos(theta_1 - theta_2))            [m2]
//   u, v      its centre in the host's frame;  s_u, s_v  signs of the corner
//   p_u, p_v  half the way from the middle to where it is flush with the host's sides; on small hosts the way counts as
//             much as 4 cm, since the middle of an edge is seen to be none of its corners
//   overhang  of its corners over the host's edges (measure/walls.h); of its centre when it is too large to fit
// Zero exactly when it stands wholly on the host, its centre in the outer half of that quarter, facing the same way.
// The released on_top_corner pulls to the point half way to the corner and forgets things that do not touch the host.
Vec2<double> SignsOf(Corner corner) {
  const bool right = corner == Corner::kBackRight || corner == Corner::kFrontRight;
  const bool front = corner == Corner::kFrontLeft || corner == Corner::kFrontRight;
  return {right ? 1.0 : -1.0, front ? 1.0 : -1.0};
}

std::optional<Shortfall> OnTopCornerShortfall(const PlacedCall& call) {
  std::string corner(CornerName(call.arguments().OneCorner("corner")));
  for (char& c : corner) c = c == '_' ? ' ' : c;
  return Worst(
      {OffBy(call.NameOf("object"), fmt::format("the {} corner of {}", corner, call.NameOf("host")), call.CostRoot())});
}

BoundCost BindOnTopCorner(const Arguments& a, const BindContext& context) {
  const int object = a.Object("object"), host = a.Object("host");
  const Footprint small = FootprintOf(context, object), large = FootprintOf(context, host);
  const bool fits = small.width_m <= large.width_m && small.depth_m <= large.depth_m;
  const Vec2<double> signs = SignsOf(a.OneCorner("corner"));
  const double across = std::max(0.0, large.width_m - small.width_m) / 4;
  const double ahead = std::max(0.0, large.depth_m - small.depth_m) / 4;
  const auto scale = [](double way_m) {
    constexpr double kNoWay_m = 0.005, kLeast_m = 0.04;
    return way_m < kNoWay_m ? 1 : std::max(1.0, kLeast_m / way_m);
  };
  const auto formula = [=]<typename T>(const Frames<T, 2>& frames) {
    const Vec2<T> p = frames[1].ToObject(frames[0].center);
    const T overhang = SquaredSticksOut(fits ? small : Footprint{}, frames[0], large, frames[1]);
    return overhang + SquaredHinge(scale(across) * (across - signs.x * p.x)) +
           SquaredHinge(scale(ahead) * (ahead - signs.y * p.y)) + Turn(frames[0].front, frames[1].front);
  };
  return MakeCost<kOnlyRelative>({object, host}, formula);
}

// Centres a rug under an object: their centres meet, as the released rug_under_central.
std::optional<Shortfall> RugUnderCenterShortfall(const PlacedCall& call) {
  return OffMiddle(call, call.arguments().Object("rug"), call.object());
}

BoundCost BindRugUnderCenter(const Arguments& a, const BindContext&) {
  return CentersMeet(a.Object("rug"), a.Object("object"));
}

// Lays a rug partly under an object and at least half before it.
//   cost = u^2 + out(v, [0, max(d / 2 - 0.15, 0)])^2 + (1 - cos^2 a)                                           [m2]
//   u, v  of the rug's centre beside and before the middle of the object's front;  d  the rug's shorter side
//   a     angle between the rug's longer side and the object's back edge
// Zero exactly when the rug is centred before the object, from half of it to 0.15 m of it under the front edge, its
// longer side along it; a half turn is the same: so it may lie under the table before a sofa as well. The
// released rug_under_central_forward compares directed edges by arccos without clipping (SEMANTICS.md section 6).
double ReachUnder(const Footprint& rug) {
  constexpr double kLeastUnder_m = 0.15;
  return std::max(0.0, std::min(rug.width_m, rug.depth_m) / 2 - kLeastUnder_m);
}

std::optional<Shortfall> RugUnderForwardShortfall(const PlacedCall& call) {
  const int rug = call.arguments().Object("rug"), object = call.object();
  const Vec2<double> p = call.FrameOf(object).ToObject(call.FrameOf(rug).center);
  const double before = p.y - call.FootprintOf(object).depth_m / 2;
  const double off = std::hypot(p.x, std::max({0.0, -before, before - ReachUnder(call.FootprintOf(rug))}));
  const std::string front = SideOf(call.Name(object), Side::kFront);
  if (const std::optional<Shortfall> miss = Worst({OffBy(call.Name(rug), "lying partly under " + front, off)})) {
    return miss;
  }
  return Worst({OffBy(call.Name(rug), "lying along " + call.Name(object), call.CostRoot())});
}

BoundCost BindRugUnderForward(const Arguments& a, const BindContext& context) {
  const int rug = a.Object("rug"), object = a.Object("object");
  const Footprint& shape = FootprintOf(context, rug);
  const bool wide = shape.width_m >= shape.depth_m;
  const double front_m = FootprintOf(context, object).depth_m / 2, reach_m = ReachUnder(shape);
  const auto formula = [=]<typename T>(const Frames<T, 2>& frames) {
    const Vec2<T>& along = wide ? frames[0].right : frames[0].front;
    const Vec2<T> p = frames[1].ToObject(frames[0].center);
    return Square(p.x) + SquaredOutside(p.y, front_m, front_m + reach_m) + Square(Cross(along, frames[1].right));
  };
  return MakeCost<kOnlyRelative>({rug, object}, formula);
}

// Lays an object under the middle of another: cost = |c1 - c2|^2 + sin^2(theta_1 - theta_2) [m2]. Zero exactly when the
// centres meet and the sides are parallel; a half turn is the same. The released io_under_central compares headings
// that wrap.
std::optional<Shortfall> UnderCenterShortfall(const PlacedCall& call) {
  const Frame<double> object = call.FrameOf(call.object()), target = call.FrameOf(call.target());
  const double angle = AngleOf(object.front, target.front);
  return Worst(
      {OffBy(call.NameOf("object"), "the middle of " + call.NameOf("target"), Norm(object.center - target.center)),
       Turned(call.NameOf("object"), "the sides of " + call.NameOf("target"), std::min(angle, kPi - angle))});
}

BoundCost BindUnderCenter(const Arguments& a, const BindContext&) {
  return MakeCost<kOnlyRelative>({a.Object("object"), a.Object("target")}, []<typename T>(const Frames<T, 2>& frames) {
    return SquaredNorm(frames[0].center - frames[1].center) + Square(Cross(frames[0].front, frames[1].front));
  });
}

constexpr ConstraintCode kStackedCode[] = {
    {"ceiling_above", BindCeilingAbove, CeilingAboveShortfall},
    {"ceiling_center", BindCeilingCenter, nullptr, "the middle of the ceiling"},
    {"on", BindOn, OnShortfall},
    {"on_top_center", BindOnTopCenter, OnTopCenterShortfall},
    {"on_top_corner", BindOnTopCorner, OnTopCornerShortfall},
    {"rug_under_center", BindRugUnderCenter, RugUnderCenterShortfall},
    {"rug_under_forward", BindRugUnderForward, RugUnderForwardShortfall},
    {"under_center", BindUnderCenter, UnderCenterShortfall},
};

}  // namespace

std::span<const ConstraintCode> StackedCode() { return kStackedCode; }

}  // namespace flair::optimizer
