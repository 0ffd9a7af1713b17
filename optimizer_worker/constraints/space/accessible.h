// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the floor in front of an object's sides free, so that one can get at it.
//   cost = sum over sides of  out(strip, floor)^2 + sum over others of depth(strip, other)^2
//                             + sum over doors of depth(strip, swing)^2                                   [m2]
//   strip  the rectangle of depth min_clearance_m before the side;  out  its corners' distance outside the floor
//   depth  shortest push that parts the two
// Others are floor objects that are not walked over and do not belong at that side: a chair that a call puts at the
// front of its desk may stand there (LinkedPairs). Zero exactly when every strip is inside the room and free. The
// released ind_accessible jumps at contact, draws random numbers for "long" and tests "mat" in "mattress" (SEMANTICS.md
// section 3).
#pragma once

#include <vector>

#include "optimizer_worker/constraints/cost.h"
#include "optimizer_worker/constraints/measure/convex_piece.h"
#include "optimizer_worker/constraints/measure/floor_shape.h"
#include "optimizer_worker/constraints/registry.h"
#include "room/scene/scene.h"

namespace flair::optimizer {

// Deep enough to stand in.
inline constexpr double kStandingRoom_m = 0.6;

class AccessibleCost final : public Cost {
 public:
  AccessibleCost(const BindContext& context, int object, std::vector<Side> sides, double clearance_m);

  std::span<const int> objects() const override { return objects_; }
  double ValueAt(std::span<const Frame<double>> frames) const override;
  double GradientAt(std::span<const Frame<double>> frames, std::span<double> gradient) const override;
  double FixedPart(std::span<const Frame<double>> frames, size_t moving) const override;
  double ValueGiven(double fixed_part, std::span<const Frame<double>> frames, size_t moving) const override;

 private:
  // Another object in the frame of this one: its centre, and how far it reaches from there to the sides and ahead.
  struct SeenFrom {
    Vec2<double> center;
    double half_across;
    double half_ahead;

    SeenFrom(const Frame<double>& own, const Footprint& footprint, const Frame<double>& frame);
  };
  // Whether it is beside, before or behind the strip of a side: then it does not block it.
  bool Apart(const SeenFrom& seen, Side side) const;
  // What depends on the object alone: floor and doors.
  template <typename T>
  T RoomCost(const Frame<T>& frame) const;
  // The object at position `other` of objects_ in the way.
  template <typename T>
  T BlockCost(const Frame<T>& frame, size_t other, const Frame<T>& other_frame) const;
  // The same, without work for objects that are too far away to be in the way of any strip.
  double BlockValue(std::span<const Frame<double>> frames, size_t other) const;

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

}  // namespace flair::optimizer
