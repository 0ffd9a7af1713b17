// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/scene/room.h"

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "optimizer_worker/constraints/measure/floor_shape.h"
#include "optimizer_worker/constraints/whole_room.h"
#include "room/geometry/convex_piece.h"
#include "room/geometry/gap.h"
#include "room/geometry/polygon.h"
#include "room/scene/scene.h"

namespace flair::optimizer {
namespace {

// Weakly prefers headings along the room's axes: cost = sin^2(2 theta) / 5, [Paper] Eq. aligned, as released.
// In a room that is not an upright rectangle theta is measured from its longest wall. Zero at every quarter turn.
BoundCost BindAligned(const Arguments& a, const BindContext& context) {
  return Aligned(context.scene, a.Object("object"));
}

// Balances the room.
//   cost = | sum a_i p_i / sum a_i - c |^2                                                         [m2]
//   a_i, p_i  footprint area and centre of object i;  c  centre of the room (of its bounding box when a rectangle)
// [Paper] Eq. balanced, as released. Any number of objects: value and gradient are written out.

class BalancedCost final : public Cost {
 public:
  // `objects` ascending, each once, at least one.
  BalancedCost(const Scene& scene, std::vector<int> objects)
      : objects_(std::move(objects)), room_center_(Centroid(scene.room.floor)) {
    double total = 0;
    for (int i : objects_) total += scene.objects[static_cast<size_t>(i)].footprint.area_m2();
    for (int i : objects_) shares_.push_back(scene.objects[static_cast<size_t>(i)].footprint.area_m2() / total);
  }

  std::span<const int> objects() const override { return objects_; }
  double ValueAt(std::span<const Frame<double>> frames) const override { return SquaredNorm(Offset(frames)); }
  double GradientAt(std::span<const Frame<double>> frames, std::span<double> gradient) const override {
    const Vec2<double> offset = Offset(frames);
    for (size_t i = 0; i < shares_.size(); ++i) {
      gradient[3 * i] = 2 * shares_[i] * offset.x;
      gradient[3 * i + 1] = 2 * shares_[i] * offset.y;
      gradient[3 * i + 2] = 0;
    }
    return SquaredNorm(offset);
  }

 private:
  // Centre of mass minus centre of the room.
  Vec2<double> Offset(std::span<const Frame<double>> frames) const {
    Vec2<double> offset = -room_center_;
    for (size_t i = 0; i < shares_.size(); ++i) offset += shares_[i] * frames[i].center;
    return offset;
  }

  std::vector<int> objects_;
  // a_i / sum a_i.
  std::vector<double> shares_;
  Vec2<double> room_center_;
};

BoundCost BindBalanced(const Arguments& a, const BindContext& context) {
  return Balanced(context.scene, a.Objects("objects"));
}

BoundCost BindDoorClear(const Arguments& a, const BindContext& context) {
  std::unique_ptr<Cost> cost = DoorClear(context.scene, a.Object("object"));
  if (cost != nullptr) return cost;
  return absl::FailedPreconditionError("no door of this room can be blocked by this object");
}

// Keeps an object on the floor.
//   cost = sum over corners C and half-planes of the floor's hull of max(-h(C), 0)^2 + sum over pockets of depth^2 [m2]
//   h(C)   signed distance of the corner from the half-plane's edge, positive inside
//   depth  penetration of the rectangle into a part of the hull that is not floor (none in a rectangle)
// Zero exactly when the whole rectangle is on the floor. For a rectangular room [Paper] Eq. in_bounds: the released
// function is 10 times this. The weight is the solver's.
BoundCost BindInBounds(const Arguments& a, const BindContext& context) {
  return InBounds(context.scene, a.Object("object"));
}

// Keeps two objects out of each other.
//   cost = max(-gap(A, B), 0)^2                                                                   [m2]
//   gap  signed gap of the two rectangles (room/geometry/gap.h): minus the length of the shortest push that parts them
// Zero exactly when they are apart or touch; continuously differentiable at contact; pushes apart in the cheapest
// direction. The paper's Eq. no_overlap sums squared edge lengths of the intersection, which jumps from 0 to 10 at
// contact and has no usable slope (SEMANTICS.md section 5).
std::unique_ptr<Cost> Apart(const Footprint& first, const Footprint& second, int a, int b) {
  // Their circles meet when the centres are closer than this.
  const double reach_m = CircumscribedRadius(first) + CircumscribedRadius(second);
  const auto formula = [=]<typename T>(const Frames<T, 2>& frames) {
    // Most pairs are far apart: their circles do not meet.
    const double dx = ValueOf(frames[0].center.x) - ValueOf(frames[1].center.x);
    const double dy = ValueOf(frames[0].center.y) - ValueOf(frames[1].center.y);
    if (dx * dx + dy * dy >= reach_m * reach_m) return T(0.0);
    return SquaredPenetration<T>(Box<T>(first, frames[0]), Box<T>(second, frames[1]));
  };
  return MakeCost<kOnlyRelative>({a, b}, formula);
}

BoundCost BindNoOverlap(const Arguments& a, const BindContext& context) {
  std::unique_ptr<Cost> cost = NoOverlapPair(context.scene, a.Object("object"), a.Object("other"));
  if (cost != nullptr) return cost;
  return absl::FailedPreconditionError("these two cannot be in each other's way");
}

// Keeps objects from floating in the middle of the room without reason.
//   cost = max(d - r - T, 0)^2                                                                     [m2]
//   d  distance of the object's centre to the nearest wall, r half its diagonal, T = 0.5 m
// [Paper] Eq. wall_attraction without its factor 1/lambda_2. Zero exactly when the object is within T of a wall. The
// released term also asks for the back to be the nearest side; that is against_wall's matter.
BoundCost BindWallAttraction(const Arguments& a, const BindContext& context) {
  return WallAttraction(context.scene, a.Object("object"));
}

constexpr ConstraintCode kRoomCode[] = {
    {"aligned", BindAligned},    {"balanced", BindBalanced},    {"door_clear", BindDoorClear},
    {"in_bounds", BindInBounds}, {"no_overlap", BindNoOverlap}, {"wall_attraction", BindWallAttraction},
};

}  // namespace

std::unique_ptr<Cost> Aligned(const Scene& scene, int object) {
  if (scene.objects[static_cast<size_t>(object)].at_round) return nullptr;
  // Unit vector along the longest wall.
  Vec2<double> axis{1, 0};
  double longest = 0;
  for (const Wall& wall : scene.room.walls) {
    if (wall.length_m > longest) longest = wall.length_m, axis = wall.Along();
  }
  const auto formula = [axis]<typename T>(const Frames<T, 1>& frames) {
    const Vec2<T> along = Cast<T>(axis);
    // sin(2 a) = 2 sin(a) cos(a), a from the axis to the object's right.
    const T sine2 = T(2.0) * Cross(along, frames[0].right) * Dot(along, frames[0].right);
    return sine2 * sine2 * T(0.2);
  };
  return MakeCost({object}, formula);
}

std::unique_ptr<Cost> Balanced(const Scene& scene, std::span<const int> objects) {
  if (objects.empty()) return nullptr;
  std::vector<int> sorted(objects.begin(), objects.end());
  std::ranges::sort(sorted);
  return std::make_unique<BalancedCost>(scene, std::move(sorted));
}

// Keeps an object out of the way of doors.
//   cost = sum over doors of  depth(swing)^2 + depth(passage)^2                                   [m2]
//   swing    the sector that the leaf really sweeps, hinge and angle as given (doors that open inwards)
//   passage  the opening's width, kPassage deep into the room, so that one can step through
//   depth    the shortest push out of the area that does not go through the wall
// Zero exactly when swings and passages are free. The paper's door term uses a square twice as wide as the door in one
// function and three different zones in all (SEMANTICS.md section 10).
std::unique_ptr<Cost> DoorClear(const Scene& scene, int object) {
  const Object& o = scene.objects[static_cast<size_t>(object)];
  std::vector<ConvexPiece> areas = DoorAreas(scene.room);
  // Doors pass over rugs and under lamps; things on tables are where the tables are.
  constexpr double kHeadroom_m = 2;
  const bool out_of_the_way = o.walk_over || o.kind == ObjectKind::kSurface ||
                              (o.kind != ObjectKind::kFloor && scene.BottomOf(object) >= kHeadroom_m);
  if (areas.empty() || out_of_the_way || o.kind == ObjectKind::kCeiling) return nullptr;
  return ClearOfAreas(object, o.footprint, std::move(areas));
}

std::unique_ptr<Cost> InBounds(const Scene& scene, int object) {
  return MakeCost<kSeesZero>({object}, [footprint = scene.objects[static_cast<size_t>(object)].footprint,
                                        floor = FloorShape(scene.room.floor)]<typename T>(const Frames<T, 1>& frames) {
    return floor.SquaredExcess(Box<T>(footprint, frames[0]));
  });
}

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

std::optional<Footprint> OpeningBelow(const Scene& scene, int object, int host) {
  const Object& what = scene.objects[static_cast<size_t>(object)];
  if (what.kind != ObjectKind::kSurface || what.host != host || what.elevation_m < 0) return std::nullopt;
  const std::optional<Footprint> opening = OpeningIn(scene.objects[static_cast<size_t>(host)]);
  if (!opening) return std::nullopt;
  const double longest_m = std::max(what.footprint.width_m, what.footprint.depth_m);
  return longest_m > std::min(opening->width_m, opening->depth_m) ? std::nullopt : opening;
}

std::unique_ptr<Cost> NoOverlapPair(const Scene& scene, int a, int b) {
  const Footprint& first = scene.objects[static_cast<size_t>(a)].footprint;
  const Footprint& second = scene.objects[static_cast<size_t>(b)].footprint;
  if (const std::optional<Footprint> below = OpeningBelow(scene, a, b)) return Apart(first, *below, a, b);
  if (const std::optional<Footprint> below = OpeningBelow(scene, b, a)) return Apart(*below, second, a, b);
  if (!CanCollide(scene, a, b)) return nullptr;
  return Apart(first, second, a, b);
}

std::unique_ptr<Cost> WallAttraction(const Scene& scene, int object) {
  const Footprint& f = scene.objects[static_cast<size_t>(object)].footprint;
  constexpr double kThreshold_m = 0.5;
  const double free_m = std::hypot(f.width_m, f.depth_m) / 2 + kThreshold_m;
  const auto formula = [walls = scene.room.walls, free_m]<typename T>(const Frames<T, 1>& frames) {
    return LeastOf<T>(walls, frames, [free_m](const Wall& wall, const auto& f) {
      const auto& center = f[0].center;
      // Beyond the ends of a wall its end counts.
      const auto height = wall.Height(center);
      const auto beyond = SquaredOutside(wall.Offset(center), 0, wall.length_m);
      using std::sqrt;
      if (ValueOf(beyond) == 0) return SquaredHinge(Magnitude(height) - free_m);
      return SquaredHinge(sqrt(height * height + beyond) - free_m);
    });
  };
  return MakeCost<kSeesZero>({object}, formula);
}

std::span<const ConstraintCode> RoomCode() { return kRoomCode; }

}  // namespace flair::optimizer
