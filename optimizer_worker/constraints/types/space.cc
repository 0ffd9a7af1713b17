// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "optimizer_worker/constraints/measure/floor_shape.h"
#include "optimizer_worker/constraints/measure/walls.h"
#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/constraints/whole_room.h"
#include "room/autodiff/dual.h"
#include "room/geometry/convex_piece.h"
#include "room/geometry/polygon.h"
#include "room/geometry/pose.h"
#include "room/scene/scene.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::optimizer {
namespace {

// Keeps the floor in front of an object's sides free, so that one can get at it.
//   cost = sum over sides of  out(strip, floor)^2 + sum over others of depth(strip, other)^2
//                             + sum over doors of depth(strip, swing)^2                                   [m2]
//   strip  the rectangle of depth min_clearance_m before the side;  out  its corners' distance outside the floor
//   depth  shortest push that parts the two
// Others are floor objects that are not walked over and do not belong at that side: a chair that a call puts at the
// front of its desk may stand there (LinkedPairs). Zero exactly when every strip is inside the room and free. The
// released ind_accessible jumps at contact, draws random numbers for "long" and tests "mat" in "mattress" (SEMANTICS.md
// section 3).

// Deep enough to stand in.
inline constexpr double kStandingRoom_m = 0.6;
// Less is no reason to name who stands there.
constexpr double kReachesIn_m = 1e-3;

class AccessibleCost final : public Cost {
 public:
  AccessibleCost(const BindContext& context, int object, std::vector<Side> sides, double clearance_m)
      : sides_(std::move(sides)), clearance_m_(clearance_m), floor_(context.scene.room.floor) {
    const std::vector<Object>& all = context.scene.objects;
    for (int i = 0; i < static_cast<int>(all.size()); ++i) {
      const Object& other = all[static_cast<size_t>(i)];
      unsigned belongs = 0;
      for (size_t k = 0; k < sides_.size() && context.linked != nullptr; ++k) {
        if (context.linked->BelongsAt(object, i, sides_[k])) belongs |= 1u << k;
      }
      const bool everywhere = belongs == (1u << sides_.size()) - 1;
      if (i != object && (other.kind != ObjectKind::kFloor || other.walk_over || everywhere)) continue;
      if (i == object) own_ = objects_.size();
      objects_.push_back(i);
      footprints_.push_back(other.footprint);
      belongs_.push_back(belongs);
      reaches_m_.push_back(std::hypot(other.footprint.width_m, other.footprint.depth_m) / 2);
    }
    // The pieces reach far behind their walls; no strip that is in the room does.
    const BoundingBox room = BoundsOf(context.scene.room.floor);
    for (ConvexPiece& piece : SwingPieces(context.scene.room)) {
      std::vector<Vec2<double>> inside;
      for (const Vec2<double>& v : piece.vertices) {
        inside.push_back({std::clamp(v.x, room.min.x, room.max.x), std::clamp(v.y, room.min.y, room.max.y)});
      }
      const BoundingBox box = BoundsOf(inside);
      // Twice as far, so that strips which lean out of the room are measured too.
      const double reach = std::hypot(box.width_m(), box.height_m());
      swings_.push_back({std::move(piece), box.Center(), reach});
    }
    const Footprint& own = footprints_[own_];
    reach_m_ = std::hypot(own.width_m / 2 + clearance_m_, own.depth_m / 2 + clearance_m_);
  }

  std::span<const int> objects() const override { return objects_; }
  double ValueAt(std::span<const Frame<double>> frames) const override {
    double sum = RoomCost(frames[own_]);
    for (size_t i = 0; i < frames.size(); ++i) {
      if (i != own_) sum += BlockValue(frames, i);
    }
    return sum;
  }
  double GradientAt(std::span<const Frame<double>> frames, std::span<double> gradient) const override {
    std::ranges::fill(gradient, 0.0);
    double sum = 0;
    if (RoomCost(frames[own_]) > 0) {
      sum += AddSingle(frames, own_, gradient, [this](const auto& f) { return RoomCost(f); });
    }
    for (size_t i = 0; i < frames.size(); ++i) {
      if (i == own_ || BlockValue(frames, i) == 0) continue;
      sum += AddPair(frames, own_, i, gradient,
                     [this, i](const auto& f, const auto& other) { return BlockCost(f, i, other); });
    }
    return sum;
  }
  double FixedPart(std::span<const Frame<double>> frames, size_t moving) const override {
    if (moving == own_) return 0;
    double sum = RoomCost(frames[own_]);
    for (size_t i = 0; i < frames.size(); ++i) {
      if (i != own_ && i != moving) sum += BlockValue(frames, i);
    }
    return sum;
  }
  double ValueGiven(double fixed_part, std::span<const Frame<double>> frames, size_t moving) const override {
    return moving == own_ ? ValueAt(frames) : fixed_part + BlockValue(frames, moving);
  }

 private:
  // Another object in the frame of this one: its centre, and how far it reaches from there to the sides and ahead.
  struct SeenFrom {
    Vec2<double> center;
    double half_across;
    double half_ahead;

    SeenFrom(const Frame<double>& own, const Footprint& footprint, const Frame<double>& frame);
  };
  // Whether it is beside, before or behind the strip of a side: then it does not block it.
  bool Apart(const SeenFrom& seen, Side side) const {
    const Footprint& own = footprints_[own_];
    const Vec2<double> n = LocalNormal(side);
    const double to_middle = (ExtentBehind(own, side) + clearance_m_) / 2;
    const bool ahead = side == Side::kFront || side == Side::kBack;
    const double half_across = (ahead ? own.width_m : clearance_m_) / 2;
    const double half_ahead = (ahead ? clearance_m_ : own.depth_m) / 2;
    return std::abs(seen.center.x - to_middle * n.x) >= half_across + seen.half_across ||
           std::abs(seen.center.y - to_middle * n.y) >= half_ahead + seen.half_ahead;
  }
  // What depends on the object alone: floor and doors.
  template <typename T>
  T RoomCost(const Frame<T>& frame) const {
    T sum(0.0);
    for (Side side : sides_) {
      const Box<T> strip = Box<T>::Before(footprints_[own_], frame, side, clearance_m_);
      sum += floor_.SquaredExcess(strip);
      for (const Swing& swing : swings_) {
        const double reach = reach_m_ + swing.reach_m;
        const double dx = ValueOf(frame.center.x) - swing.center.x, dy = ValueOf(frame.center.y) - swing.center.y;
        if (dx * dx + dy * dy < reach * reach) sum += SquaredPenetration<T>(strip, swing.piece);
      }
    }
    return sum;
  }
  // The object at position `other` of objects_ in the way.
  template <typename T>
  T BlockCost(const Frame<T>& frame, size_t other, const Frame<T>& other_frame) const {
    const SeenFrom seen(ValueOf(frame), footprints_[other], ValueOf(other_frame));
    T sum(0.0);
    for (size_t k = 0; k < sides_.size(); ++k) {
      if ((belongs_[other] >> k & 1u) != 0 || Apart(seen, sides_[k])) continue;
      sum += SquaredPenetration<T>(Box<T>::Before(footprints_[own_], frame, sides_[k], clearance_m_),
                                   Box<T>(footprints_[other], other_frame));
    }
    return sum;
  }
  // The same, without work for objects that are too far away to be in the way of any strip.
  double BlockValue(std::span<const Frame<double>> frames, size_t other) const {
    const double reach = reach_m_ + reaches_m_[other];
    if (SquaredNorm(frames[own_].center - frames[other].center) >= reach * reach) return 0;
    return BlockCost(frames[own_], other, frames[other]);
  }

  std::vector<int> objects_;
  // In the order of objects_.
  std::vector<Footprint> footprints_;
  // From their centres to their corners.
  std::vector<double> reaches_m_;
  // Bit k: it belongs at sides_[k].
  std::vector<unsigned> belongs_;
  // Where the object itself is in objects_.
  size_t own_ = 0;
  std::vector<Side> sides_;
  double clearance_m_;
  // From the centre to the furthest point of any strip.
  double reach_m_;
  FloorShape floor_;
  // With a circle around what each sweeps inside the room.
  struct Swing {
    ConvexPiece piece;
    Vec2<double> center;
    double reach_m;
  };
  std::vector<Swing> swings_;
};

AccessibleCost::SeenFrom::SeenFrom(const Frame<double>& own, const Footprint& footprint, const Frame<double>& frame)
    : center(own.ToObject(frame.center)) {
  const double w = footprint.width_m / 2, d = footprint.depth_m / 2;
  half_across = std::abs(Dot(own.right, frame.right)) * w + std::abs(Dot(own.right, frame.front)) * d;
  half_ahead = std::abs(Dot(own.front, frame.right)) * w + std::abs(Dot(own.front, frame.front)) * d;
}

// How deep the floor before a side is free of another object that stands before it.
double FreeBefore(const PlacedCall& call, Side side, int other, double depth_m) {
  double free_m = 0;
  for (double blocked_m = depth_m; blocked_m - free_m > 1e-3;) {
    const double middle_m = (free_m + blocked_m) / 2;
    const Box<double> strip =
        Box<double>::Before(call.FootprintOf(call.object()), call.FrameOf(call.object()), side, middle_m);
    (Gap<double>(strip, call.BoxOf(other)) < -1e-6 ? blocked_m : free_m) = middle_m;
  }
  return free_m;
}

std::optional<Shortfall> AccessibleShortfall(const PlacedCall& call) {
  const int object = call.object();
  const double depth =
      call.arguments().Has("min_clearance_m") ? call.arguments().Number("min_clearance_m") : kStandingRoom_m;
  std::vector<Shortfall> misses;
  for (Side side : call.arguments().Sides("sides")) {
    const Box<double> strip = Box<double>::Before(call.FootprintOf(object), call.FrameOf(object), side, depth);
    const std::string floor = fmt::format("the {:.2f} m before {}", depth, SideOf(call.Name(object), side));
    // What stands in it is to blame before what just touches its side.
    double most = kReachesIn_m;
    std::optional<Shortfall> deepest;
    for (int i = 0; i < static_cast<int>(call.scene().objects.size()); ++i) {
      const Object& other = call.scene().objects[static_cast<size_t>(i)];
      const bool belongs = call.linked() != nullptr && call.linked()->BelongsAt(object, i, side);
      if (i == object || other.kind != ObjectKind::kFloor || other.walk_over || belongs) continue;
      const double within = -Gap<double>(strip, call.BoxOf(i));
      if (within < most) continue;
      most = std::nextafter(within, depth + within);
      const double into = depth - FreeBefore(call, side, i, depth);
      deepest = {fmt::format("{} reaches {:.2f} m into {}", call.Name(i), into, floor), into, "m"};
    }
    if (deepest) misses.push_back(*deepest);
    // Which wall each corner of it is behind: the nearest one, for a room that is not convex has walls to all sides.
    for (int k = 0; k < 4; ++k) {
      const Vec2<double> corner = strip.value(k);
      if (call.scene().room.walls.empty() || Contains(call.scene().room.floor, corner)) continue;
      const auto distance = [&](const Wall& wall) { return DistanceTo(Segment{wall.start, wall.end}, corner); };
      const Wall& wall = *std::ranges::min_element(call.scene().room.walls, {}, distance);
      const double beyond = distance(wall);
      misses.push_back(
          {fmt::format("{} are cut off by {} by {:.2f} m", floor, WallName(call.scene().room, wall), beyond), beyond,
           "m"});
    }
  }
  if (const std::optional<Shortfall> worst = Worst(misses)) return worst;
  const double into = call.CostRoot();
  return Worst({{fmt::format("a door swings {:.2f} m into the floor before {}", into, call.Name(object)), into, "m"}});
}

BoundCost BindAccessible(const Arguments& a, const BindContext& context) {
  const double clearance = a.Has("min_clearance_m") ? a.Number("min_clearance_m") : kStandingRoom_m;
  return std::make_unique<AccessibleCost>(context, a.Object("object"), a.Sides("sides"), clearance);
}

// Keeps an object in the middle of the room.
//   cost = min(hx^2, hy^2), or hx^2 + hy^2 with both                                                         [m2]
//   hx, hy  distance of the centre outside the middle third of the room's bounding box, east-west and north-south; with
//   both outside its middle sixth, or what is within 0.25 m of the middle in larger rooms
// Zero exactly when the centre is there along one axis (or both). The released ind_central multiplies hx
// and hy, so that it is flat along either third, and adds a heading term that whole-room alignment has already.
BoundCost BindCentral(const Arguments& a, const BindContext& context) {
  const BoundingBox box = BoundsOf(context.scene.room.floor);
  const bool both = a.Flag("both");
  const auto formula = [=]<typename T>(const Frames<T, 1>& frames) {
    const auto outside = [both](const T& x, double low, double high) {
      // What is in the middle of a room on both axes is seen to be so, in large rooms as well.
      constexpr double kSeen_m = 0.25;
      const double beside = both ? std::min((high - low) / 12, kSeen_m) : (high - low) / 6;
      return SquaredOutside(x, (low + high) / 2 - beside, (low + high) / 2 + beside);
    };
    const T across = outside(frames[0].center.x, box.min.x, box.max.x);
    const T along = outside(frames[0].center.y, box.min.y, box.max.y);
    if (both) return across + along;
    return across < along ? across : along;
  };
  return MakeCost({a.Object("object")}, formula);
}

// Turns an object's front into the room.
//   cost = max(a - pi / 4, 0)^2                                                                              [rad2]
//   a  angle between its front and the direction from its centre to the room's centre
// Zero exactly when it faces the middle of the room within 45 degrees; any heading will do in the very middle. The
// released ind_facing_into_room is this with arccos without clipping, which scores 0 for many objects that are turned
// exactly away.
template <Look kLook>
std::optional<Shortfall> FacingIntoRoomShortfall(const PlacedCall& call) {
  const Frame<double> frame = LookOf(call.FrameOf(call.object()), kLook);
  const Vec2<double> center = BoundsOf(call.scene().room.floor).Center();
  return Worst({Turned(WhoLooks(call, call.object(), kLook), "the middle of the room",
                       AngleOf(frame.front, center - frame.center), kPi / 4)});
}

template <Look kLook>
BoundCost BindFacingIntoRoom(const Arguments& a, const BindContext& context) {
  const auto formula = [room_center = Centroid(context.scene.room.floor)]<typename T>(const Frames<T, 1>& frames) {
    using std::atan2;
    const Vec2<T> to_center = Cast<T>(room_center) - frames[0].center;
    constexpr double kNoDirection_m2 = 1e-8;
    if (ValueOf(SquaredNorm(to_center)) < kNoDirection_m2) return T(0.0);
    const Vec2<T> front = LookOf(frames[0], kLook).front;
    const T angle = atan2(Magnitude(Cross(front, to_center)), Dot(front, to_center));
    return SquaredHinge(angle - kPi / 4);
  };
  return MakeCost({a.Object("object")}, formula);
}

// Keeps an object's centre in the Voronoi cell of a zone: cost as in measure/walls.h [m2]. Zero exactly in the cell.
// The released ind_in_region is 5 times this.
std::unique_ptr<Cost> InZone(int object, std::span<const Vec2<double>> zone_centers, int zone) {
  return MakeCost({object},
                  [centers = std::vector(zone_centers.begin(), zone_centers.end()), zone]<typename T>(
                      const Frames<T, 1>& frames) { return SquaredBeyondBorders<T>(frames[0].center, centers, zone); });
}

BoundCost BindInZone(const Arguments& a, const BindContext& context) {
  const int zone = a.Zone("zone");
  RETURN_IF_ERROR(CheckHasPlace(context, zone));
  return InZone(a.Object("object"), context.zone_centers, zone);
}

// The whole-room term "zone": in_zone for an object and the zone it belongs to. [Paper] Eq. zone.

BoundCost BindZoneAffinity(const Arguments& a, const BindContext& context) {
  std::unique_ptr<Cost> cost = ZoneAffinity(context.scene, a.Object("object"), context.zone_centers);
  if (cost != nullptr) return cost;
  return absl::FailedPreconditionError("the object has no zone, or there is one zone only");
}

constexpr ConstraintCode kSpaceCode[] = {
    {"accessible", BindAccessible, AccessibleShortfall},
    {"central", BindCentral, nullptr, "the middle part of the room"},
    {"facing_into_room", BindFacingIntoRoom<Look::kOwn>, FacingIntoRoomShortfall<Look::kOwn>},
    {"in_zone", BindInZone, OffZone},
    {"user_faces_room", BindFacingIntoRoom<Look::kOfUser>, FacingIntoRoomShortfall<Look::kOfUser>},
    {"zone", BindZoneAffinity},
};

}  // namespace

std::unique_ptr<Cost> ZoneAffinity(const Scene& scene, int object, std::span<const Vec2<double>> zone_centers) {
  const int zone = scene.objects[static_cast<size_t>(object)].zone;
  if (zone < 0 || zone_centers.size() < 2 || !HasPlace(zone_centers[static_cast<size_t>(zone)])) return nullptr;
  return InZone(object, zone_centers, zone);
}

std::span<const ConstraintCode> SpaceCode() { return kSpaceCode; }

}  // namespace flair::optimizer
