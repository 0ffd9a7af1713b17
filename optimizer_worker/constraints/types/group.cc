// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/linked_pairs.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "optimizer_worker/constraints/measure/floor_shape.h"
#include "optimizer_worker/constraints/measure/walls.h"
#include "room/autodiff/dual.h"
#include "room/geometry/pose.h"
#include "room/scene/scene.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::optimizer {
namespace {

// Stands objects side by side.
//   cost = sum over neighbours (a left of b) of  out(gap - gap_m, [0, 0.05])^2 + offset^2
//          + (1 - cos(theta_a - theta_b))                                                                        [m2]
//   gap     air between the right side of a and the left side of b;  offset  of b's back from the line of a's back
// Neighbours are next to each other in order along the first object's right, wherever they stand in the list. Zero
// exactly when they form one row with flush backs and the same heading.

class RowCost final : public Cost {
 public:
  static constexpr int kMaxObjects = 16;

  // Two to kMaxObjects objects.
  RowCost(const Scene& scene, const std::vector<int>& objects, double gap_m) : objects_(objects), gap_m_(gap_m) {
    std::ranges::sort(objects_);
    for (int i : objects_) footprints_.push_back(scene.objects[static_cast<size_t>(i)].footprint);
  }

  std::span<const int> objects() const override { return objects_; }
  double ValueAt(std::span<const Frame<double>> frames) const override {
    const auto order = Order(frames);
    double sum = 0;
    for (size_t k = 0; k + 1 < frames.size(); ++k) {
      sum += NeighbourCost(footprints_[order[k]], frames[order[k]], footprints_[order[k + 1]], frames[order[k + 1]]);
    }
    return sum;
  }
  double GradientAt(std::span<const Frame<double>> frames, std::span<double> gradient) const override {
    std::ranges::fill(gradient, 0.0);
    const auto order = Order(frames);
    double sum = 0;
    for (size_t k = 0; k + 1 < frames.size(); ++k) {
      const size_t left = order[k], right = order[k + 1];
      sum += AddPair(frames, left, right, gradient, [this, left, right](const auto& a, const auto& b) {
        return NeighbourCost(footprints_[left], a, footprints_[right], b);
      });
    }
    return sum;
  }

 private:
  // Positions in objects_, from left to right.
  std::array<size_t, kMaxObjects> Order(std::span<const Frame<double>> frames) const {
    std::array<size_t, kMaxObjects> order{};
    std::array<double, kMaxObjects> place{};
    const Vec2<double> right = frames[0].right;
    for (size_t i = 0; i < frames.size(); ++i) {
      order[i] = i;
      place[i] = Dot(right, frames[i].center);
    }
    std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(frames.size()),
              [&place](size_t a, size_t b) { return place[a] != place[b] ? place[a] < place[b] : a < b; });
    return order;
  }
  template <typename T>
  T NeighbourCost(const Footprint& left, const Frame<T>& left_frame, const Footprint& right,
                  const Frame<T>& right_frame) const {
    constexpr double kAir_m = 0.05;
    const Vec2<T> p = left_frame.ToObject(right_frame.center);
    const T gap = p.x - (left.width_m + right.width_m) / 2;
    const T offset = p.y - (right.depth_m - left.depth_m) / 2;
    return SquaredOutside(gap, gap_m_, gap_m_ + kAir_m) + Square(offset) + Turn(left_frame.front, right_frame.front);
  }

  std::vector<int> objects_;
  double gap_m_;
  std::vector<Footprint> footprints_;
};

std::optional<Shortfall> RowShortfall(const PlacedCall& call) {
  const std::vector<int>& objects = call.arguments().Objects("objects");
  return Worst(
      {OffBy(fmt::format("one of {} and its neighbours", call.Name(objects[0])), "one flush row", call.CostRoot())});
}

BoundCost BindRow(const Arguments& a, const BindContext& context) {
  const std::vector<int>& objects = a.Objects("objects");
  if (objects.size() < 2 || objects.size() > static_cast<size_t>(RowCost::kMaxObjects)) {
    return InvalidArgument("argument objects: {} cannot form a row; give 2 to {}", objects.size(),
                           RowCost::kMaxObjects);
  }
  return std::make_unique<RowCost>(context.scene, objects, a.Number("gap_m"));
}

constexpr double kAir_m = 0.1, kMostPlay_m = 0.03;

size_t PositionOf(const std::vector<int>& sorted, int object) {
  return static_cast<size_t>(std::ranges::lower_bound(sorted, object) - sorted.begin());
}

// Seats objects round a centre object.
//   cost = sum over seats of  out(gap - gap_m, [0, 0.1])^2 + max(|along - place| - play, 0)^2 + (1 + f . n) [m2] gap,
//   along  of the middle of the seat's front, outward from and along the side of the centre object f, n        the
//   seat's front direction and the side's outward normal
// Places: one on every side of the centre object that has room for a seat, long sides first (two seats: the two long
// sides unless they keep a distance), the rest where most length is left; evenly spread along each side, play a quarter of the spare width, at most
// kMostPlay_m. Seats take the places that cost least together. Round what is round the places are evenly spread, the
// first before its front or, where that has no room, half a place further. Zero exactly when every seat is at a place
// of its own and faces the centre object. Sides are judged where the centre object is now: the cost may jump when it
// comes too near to a wall. The released io_surround deals places in list order round a stale pose (SEMANTICS.md
// section 4).

class SurroundCost final : public Cost {
 public:
  static constexpr int kMaxSeats = kMostSeats;

  // At most kMaxSeats seats.
  SurroundCost(const Scene& scene, int center, const std::vector<int>& seats, double gap_m)
      : objects_(seats),
        gap_m_(gap_m),
        table_(scene.objects[static_cast<size_t>(center)].footprint),
        round_(scene.objects[static_cast<size_t>(center)].round),
        floor_(scene.room.floor) {
    objects_.push_back(center);
    std::ranges::sort(objects_);
    center_ = PositionOf(objects_, center);
    shallowest_m_ = scene.objects[static_cast<size_t>(seats[0])].footprint.depth_m;
    for (int seat : seats) {
      seats_.push_back(PositionOf(objects_, seat));
      footprints_.push_back(scene.objects[static_cast<size_t>(seat)].footprint);
      widest_m_ = std::max(widest_m_, footprints_.back().width_m);
      shallowest_m_ = std::min(shallowest_m_, footprints_.back().depth_m);
    }
  }

  std::span<const int> objects() const override { return objects_; }
  double ValueAt(std::span<const Frame<double>> frames) const override {
    const Frame<double> center = frames[center_];
    const Places places = PlacesAround(center);
    const std::array<int, kMaxSeats> place_of = Assign(frames, places);
    double sum = 0;
    for (size_t i = 0; i < seats_.size(); ++i) {
      sum += SeatCost(center, frames[seats_[i]], footprints_[i], places.items[static_cast<size_t>(place_of[i])]);
    }
    return sum;
  }
  double GradientAt(std::span<const Frame<double>> frames, std::span<double> gradient) const override {
    std::ranges::fill(gradient, 0.0);
    const Places places = PlacesAround(frames[center_]);
    const std::array<int, kMaxSeats> place_of = Assign(frames, places);
    double sum = 0;
    for (size_t i = 0; i < seats_.size(); ++i) {
      const Place& place = places.items[static_cast<size_t>(place_of[i])];
      sum += AddPair(frames, center_, seats_[i], gradient, [this, i, &place](const auto& center, const auto& seat) {
        return SeatCost(center, seat, footprints_[i], place);
      });
    }
    return sum;
  }

 private:
  struct Place {
    // Outward, in the frame of the centre object, and how far its edge is that way.
    Vec2<double> normal;
    double reach_m;
    // Along the side from its middle.
    double along_m;
    double play_m;
  };
  struct Places {
    std::array<Place, kMaxSeats> items;
    int count = 0;
  };

  Places PlacesAround(const Frame<double>& center) const {
    const int seats = static_cast<int>(seats_.size());
    const bool wide = table_.width_m >= table_.depth_m;
    const std::array<Side, 4> order = wide ? std::array<Side, 4>{Side::kFront, Side::kBack, Side::kLeft, Side::kRight}
                                           : std::array<Side, 4>{Side::kLeft, Side::kRight, Side::kFront, Side::kBack};
    std::array<bool, 4> free{};
    int free_count = 0;
    Places places;
    if (round_) {
      if (!SpreadEvenly(center, 0, places) && !SpreadEvenly(center, 0.5, places)) SpreadEvenly(center, 0, places);
      return places;
    }
    for (size_t k = 0; k < 4; ++k) free_count += free[k] = HasRoom(center, order[k]);
    if (free_count == 0) free.fill(true), free_count = 4;

    if (seats == 2 && gap_m_ == 0 && free[0] && free[1]) free[2] = free[3] = false, free_count = 2;
    std::array<int, 4> counts{};
    for (size_t k = 0; k < 4; ++k) counts[k] = free[k];
    for (int left = seats - free_count; left > 0; --left) {
      size_t best = 4;
      for (size_t k = 0; k < 4; ++k) {
        const double spare = free[k] ? SideLength(table_, order[k]) / (counts[k] + 1) : -1;
        if (best == 4 || spare > SideLength(table_, order[best]) / (counts[best] + 1)) best = free[k] ? k : best;
      }
      ++counts[best];
    }
    for (size_t k = 0; k < 4; ++k) AddPlaces(order[k], counts[k], places);
    return places;
  }
  // False where one of the places has no room.
  bool SpreadEvenly(const Frame<double>& center, double start, Places& places) const {
    const double turn = 2 * kPi / static_cast<double>(seats_.size());
    double radius_m = std::min(table_.width_m, table_.depth_m) / 2;
    // Those who keep a distance keep as much as they need to sit side by side.
    if (gap_m_ > 0 && seats_.size() > 2)
      radius_m = std::max(radius_m, (widest_m_ + kAir_m) / 2 / std::tan(turn / 2) - gap_m_);
    bool room = true;
    places.count = 0;
    for (size_t i = 0; i < seats_.size(); ++i) {
      const double angle = kPi / 2 + (static_cast<double>(i) + start) * turn;
      const Vec2<double> normal{std::cos(angle), std::sin(angle)};
      const double outer_m = radius_m + gap_m_ + shallowest_m_;
      room = room && floor_.SquaredExcess(center.ToRoom(outer_m * normal.x, outer_m * normal.y)) == 0;
      places.items[static_cast<size_t>(places.count++)] = {normal, radius_m, 0, 0.02};
    }
    return room;
  }
  bool HasRoom(const Frame<double>& center, Side side) const {
    const Vec2<double> outer = MiddleOf(table_, center, side) + (gap_m_ + shallowest_m_) * NormalOf(center, side);
    return floor_.SquaredExcess(outer) == 0;
  }
  void AddPlaces(Side side, int count, Places& places) const {
    const double spacing = SideLength(table_, side) / count;
    for (int i = 0; i < count; ++i) {
      places.items[static_cast<size_t>(places.count++)] = {LocalNormal(side), ExtentBehind(table_, side) / 2,
                                                           (i + 0.5 - count / 2.0) * spacing,
                                                           std::clamp((spacing - widest_m_) / 4, 0.0, kMostPlay_m)};
    }
  }
  // The place of each seat, cheapest together: greedy, then exchanged pairwise while that helps.
  std::array<int, kMaxSeats> Assign(std::span<const Frame<double>> frames, const Places& places) const {
    std::array<std::array<double, kMaxSeats>, kMaxSeats> cost;
    const Frame<double> center = frames[center_];
    const size_t seats = seats_.size();
    const size_t count = static_cast<size_t>(places.count);
    for (size_t i = 0; i < seats; ++i) {
      const Frame<double> seat = frames[seats_[i]];
      for (size_t p = 0; p < count; ++p) cost[i][p] = SeatCost(center, seat, footprints_[i], places.items[p]);
    }
    std::array<int, kMaxSeats> of_place;
    of_place.fill(-1);
    std::array<int, kMaxSeats> place_of;
    place_of.fill(-1);
    for (size_t round = 0; round < seats; ++round) {
      size_t best_seat = 0, best_place = 0;
      double least = -1;
      for (size_t i = 0; i < seats; ++i) {
        if (place_of[i] >= 0) continue;
        for (size_t p = 0; p < count; ++p) {
          if (of_place[p] < 0 && (least < 0 || cost[i][p] < least)) least = cost[i][p], best_seat = i, best_place = p;
        }
      }
      place_of[best_seat] = static_cast<int>(best_place);
      of_place[best_place] = static_cast<int>(best_seat);
    }
    // Each exchange lowers the sum, so this ends; the bound is for rounding.
    bool better = true;
    for (size_t round = 0; better && round < 4 * kMaxSeats; ++round) {
      better = false;
      for (size_t i = 0; i < seats; ++i) {
        for (size_t p = 0; p < count; ++p) {
          const size_t own = static_cast<size_t>(place_of[i]);
          if (p == own) continue;
          const int other = of_place[p];
          const double before = cost[i][own] + (other < 0 ? 0 : cost[static_cast<size_t>(other)][p]);
          const double after = cost[i][p] + (other < 0 ? 0 : cost[static_cast<size_t>(other)][own]);
          if (after >= before - 1e-12) continue;
          of_place[p] = static_cast<int>(i);
          of_place[own] = other;
          place_of[i] = static_cast<int>(p);
          if (other >= 0) place_of[static_cast<size_t>(other)] = static_cast<int>(own);
          better = true;
        }
      }
    }
    return place_of;
  }
  template <typename T>
  T SeatCost(const Frame<T>& center, const Frame<T>& seat, const Footprint& footprint, const Place& place) const {
    const Vec2<double>& n = place.normal;
    const Vec2<T> front = center.ToObject(MiddleOf(footprint, seat, Side::kFront));
    const T gap = n.x * front.x + n.y * front.y - place.reach_m;
    const T along = n.x * front.y - n.y * front.x;
    return SquaredOutside(gap, gap_m_, gap_m_ + kAir_m) +
           SquaredOutside(along - place.along_m, -place.play_m, place.play_m) +
           (Dot(seat.front, n.x * center.right + n.y * center.front) + 1.0);
  }

  std::vector<int> objects_;
  double gap_m_;
  // Where the centre and the seats are in objects_.
  size_t center_ = 0;
  std::vector<size_t> seats_;
  Footprint table_;
  bool round_;
  std::vector<Footprint> footprints_;
  double widest_m_ = 0;
  double shallowest_m_ = 0;
  FloorShape floor_;
};

std::optional<Shortfall> SurroundShortfall(const PlacedCall& call) {
  const std::string center = call.Name(call.arguments().Object("center"));
  std::vector<Shortfall> misses;
  const double gap_m = call.arguments().Number("gap_m");
  for (int seat : call.arguments().Objects("objects")) {
    const Frame<double> frame = call.FrameOf(seat);
    const Vec2<double> to_center = call.FrameOf(call.arguments().Object("center")).center - frame.center;
    misses.push_back(TooFar(call.Name(seat), center, call.GapBetween(seat, call.arguments().Object("center")),
                            gap_m > 0 ? HUGE_VAL : kAir_m));
    misses.push_back(Turned(SideOf(call.Name(seat), Side::kFront), center, AngleOf(frame.front, to_center), kPi / 4));
  }
  if (const std::optional<Shortfall> worst = Worst(misses)) return worst;
  return Worst({OffBy("one of those round " + center, "an even place", call.CostRoot())});
}

BoundCost BindSurround(const Arguments& a, const BindContext& context) {
  const std::vector<int>& seats = a.Objects("objects");
  if (seats.size() > static_cast<size_t>(SurroundCost::kMaxSeats)) {
    return InvalidArgument("argument objects: {} are too many; at most {}", seats.size(), SurroundCost::kMaxSeats);
  }
  return std::make_unique<SurroundCost>(context.scene, a.Object("center"), seats, a.Number("gap_m"));
}

constexpr ConstraintCode kGroupCode[] = {
    {"row", BindRow, RowShortfall},
    {"surround", BindSurround, SurroundShortfall},
};

}  // namespace

std::span<const ConstraintCode> GroupCode() { return kGroupCode; }

}  // namespace flair::optimizer
