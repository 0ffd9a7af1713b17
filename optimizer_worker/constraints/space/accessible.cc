// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/space/accessible.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "optimizer_worker/constraints/room/door_clear.h"

namespace flair::optimizer {

AccessibleCost::AccessibleCost(const BindContext& context, int object, std::vector<Side> sides, double clearance_m)
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

template <typename T>
T AccessibleCost::RoomCost(const Frame<T>& frame) const {
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

AccessibleCost::SeenFrom::SeenFrom(const Frame<double>& own, const Footprint& footprint, const Frame<double>& frame)
    : center(own.ToObject(frame.center)) {
  const double w = footprint.width_m / 2, d = footprint.depth_m / 2;
  half_across = std::abs(Dot(own.right, frame.right)) * w + std::abs(Dot(own.right, frame.front)) * d;
  half_ahead = std::abs(Dot(own.front, frame.right)) * w + std::abs(Dot(own.front, frame.front)) * d;
}

bool AccessibleCost::Apart(const SeenFrom& seen, Side side) const {
  const Footprint& own = footprints_[own_];
  const Vec2<double> n = LocalNormal(side);
  const double to_middle = (ExtentBehind(own, side) + clearance_m_) / 2;
  const bool ahead = side == Side::kFront || side == Side::kBack;
  const double half_across = (ahead ? own.width_m : clearance_m_) / 2;
  const double half_ahead = (ahead ? clearance_m_ : own.depth_m) / 2;
  return std::abs(seen.center.x - to_middle * n.x) >= half_across + seen.half_across ||
         std::abs(seen.center.y - to_middle * n.y) >= half_ahead + seen.half_ahead;
}

template <typename T>
T AccessibleCost::BlockCost(const Frame<T>& frame, size_t other, const Frame<T>& other_frame) const {
  const SeenFrom seen(ValueOf(frame), footprints_[other], ValueOf(other_frame));
  T sum(0.0);
  for (size_t k = 0; k < sides_.size(); ++k) {
    if ((belongs_[other] >> k & 1u) != 0 || Apart(seen, sides_[k])) continue;
    sum += SquaredPenetration<T>(Box<T>::Before(footprints_[own_], frame, sides_[k], clearance_m_),
                                 Box<T>(footprints_[other], other_frame));
  }
  return sum;
}

double AccessibleCost::BlockValue(std::span<const Frame<double>> frames, size_t other) const {
  const double reach = reach_m_ + reaches_m_[other];
  if (SquaredNorm(frames[own_].center - frames[other].center) >= reach * reach) return 0;
  return BlockCost(frames[own_], other, frames[other]);
}

double AccessibleCost::ValueAt(std::span<const Frame<double>> frames) const {
  double sum = RoomCost(frames[own_]);
  for (size_t i = 0; i < frames.size(); ++i) {
    if (i != own_) sum += BlockValue(frames, i);
  }
  return sum;
}

double AccessibleCost::FixedPart(std::span<const Frame<double>> frames, size_t moving) const {
  if (moving == own_) return 0;
  double sum = RoomCost(frames[own_]);
  for (size_t i = 0; i < frames.size(); ++i) {
    if (i != own_ && i != moving) sum += BlockValue(frames, i);
  }
  return sum;
}

double AccessibleCost::ValueGiven(double fixed_part, std::span<const Frame<double>> frames, size_t moving) const {
  return moving == own_ ? ValueAt(frames) : fixed_part + BlockValue(frames, moving);
}

double AccessibleCost::GradientAt(std::span<const Frame<double>> frames, std::span<double> gradient) const {
  std::fill(gradient.begin(), gradient.end(), 0.0);
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

namespace {

std::optional<Shortfall> AccessibleShortfall(const PlacedCall& call) {
  const int object = call.object();
  const double depth =
      call.arguments().Has("min_clearance_m") ? call.arguments().Number("min_clearance_m") : kStandingRoom_m;
  std::vector<Shortfall> misses;
  for (Side side : call.arguments().Sides("sides")) {
    const Box<double> strip = Box<double>::Before(call.FootprintOf(object), call.FrameOf(object), side, depth);
    const std::string floor = fmt::format("the {:.2f} m before {}", depth, SideOf(call.Name(object), side));
    for (int i = 0; i < static_cast<int>(call.scene().objects.size()); ++i) {
      const Object& other = call.scene().objects[static_cast<size_t>(i)];
      const bool belongs = call.linked() != nullptr && call.linked()->BelongsAt(object, i, side);
      if (i == object || other.kind != ObjectKind::kFloor || other.walk_over || belongs) continue;
      const double into = -Gap<double>(strip, call.BoxOf(i));
      misses.push_back({fmt::format("{} reaches {:.2f} m into {}", call.Name(i), into, floor), into, "m"});
    }
    for (const Wall& wall : call.scene().room.walls) {
      double beyond = 0;
      for (int k = 0; k < 4; ++k) beyond = std::max(beyond, -wall.Height(strip.value(k)));
      misses.push_back({fmt::format("{} are cut off by {} by {:.2f} m", floor, WallName(wall), beyond), beyond, "m"});
    }
  }
  if (const std::optional<Shortfall> worst = Worst(misses)) return worst;
  const double into = call.CostRoot();
  return Worst({{fmt::format("a door swings {:.2f} m into the floor before {}", into, call.Name(object)), into, "m"}});
}

}  // namespace

ConstraintFacts AccessibleFacts() {
  return {
      .name = "accessible",
      .aliases = {"ind_accessible", "io_accessible"},
      .family = "space",
      .summary = "The floor before the given sides of `object` is free and inside the room, `min_clearance_m` deep.",
      .phrase = "has {min_clearance_m|0.60 m} of free floor before its {sides}",
      .doc =
          "cost = sum over sides of squared distances of the clearance rectangle outside the room + squared "
          "penetration of "
          "it by other floor objects (rugs and objects that belong there exempt) and by door swings [m2]. Without "
          "min_clearance_m it is 0.6 m. The released function jumps at contact.",
      .parameters = {ObjectParameter("object", "What is to be reached."),
                     SidesParameter("sides", "From which sides.", {Side::kFront}),
                     [] {
                       v1::ParameterSpec spec =
                           LengthParameter("min_clearance_m", "Depth of the free floor; 0.6 m when left out.", 0, 5, 0);
                       spec.clear_default_value();
                       return spec;
                     }()},
      .sentences = {{"The wardrobe must be accessible from the front.", "object=wardrobe"},
                    {"There is space to walk on both sides of the bed.", "object=bed sides=left,right"},
                    {"Leave one metre free in front of the oven.", "object=oven min_clearance_m=1"}},
      .layouts = {Satisfied("4x4 room; bed 1.6x2 at 2,1,0; desk 1x0.6 at 2,3.7,180", "object=bed sides=front,left"),
                  Violated("4x4 room; bed 1.6x2 at 2,1,0; desk 1x0.6 at 2.1,2.6,170", "object=bed"),
                  Violated("4x4 room; bed 1.6x2 at 1,1,4; desk 1x0.6 at 2,3.7,180", "object=bed sides=left"),
                  Violated("4x4 room; door south 0.1 0.9; bed 1.6x2 at 2.2,1,5", "object=bed sides=left")},
      .shortfall = AccessibleShortfall,
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        const double clearance = a.Has("min_clearance_m") ? a.Number("min_clearance_m") : kStandingRoom_m;
        return std::make_unique<AccessibleCost>(context, a.Object("object"), a.Sides("sides"), clearance);
      }};
}

}  // namespace flair::optimizer
