// SPDX-License-Identifier: GPL-3.0-or-later
// Seats objects round a centre object.
//   cost = sum over seats of  out(gap, [0, 0.1])^2 + max(|along - place| - play, 0)^2 + (1 + f . n)              [m2]
//   gap, along  of the middle of the seat's front, outward from and along the side of the centre object
//   f, n        the seat's front direction and the side's outward normal
// Places: one on every side of the centre object that has room for a seat, long sides first (two seats: the two long
// sides), the rest where most length is left; evenly spread along each side, play a quarter of the spare width. Seats
// take the places that cost least together. Zero exactly when every seat is at a place of its own and faces the centre
// object. Sides are judged where the centre object is now: the cost may jump when it comes too near to a wall. The
// released io_surround deals places in list order round a stale pose (SEMANTICS.md section 4).
#pragma once

#include <array>
#include <vector>

#include "optimizer_worker/constraints/cost.h"
#include "optimizer_worker/constraints/measure/floor_shape.h"
#include "room/scene/scene.h"

namespace flair::optimizer {

class SurroundCost final : public Cost {
 public:
  static constexpr int kMaxSeats = 16;

  // At most kMaxSeats seats.
  SurroundCost(const Scene& scene, int center, const std::vector<int>& seats);

  std::span<const int> objects() const override { return objects_; }
  double ValueAt(std::span<const Frame<double>> frames) const override;
  double GradientAt(std::span<const Frame<double>> frames, std::span<double> gradient) const override;

 private:
  struct Place {
    Side side;
    // Along the side from its middle.
    double along_m;
    double play_m;
  };
  struct Places {
    std::array<Place, kMaxSeats> items;
    int count = 0;
  };

  Places PlacesAround(const Frame<double>& center) const;
  bool HasRoom(const Frame<double>& center, Side side) const;
  void AddPlaces(Side side, int count, Places& places) const;
  // The place of each seat, cheapest together: greedy, then exchanged pairwise while that helps.
  std::array<int, kMaxSeats> Assign(std::span<const Frame<double>> frames, const Places& places) const;
  template <typename T>
  T SeatCost(const Frame<T>& center, const Frame<T>& seat, const Footprint& footprint, const Place& place) const;

  std::vector<int> objects_;
  // Where the centre and the seats are in objects_.
  size_t center_ = 0;
  std::vector<size_t> seats_;
  Footprint table_;
  std::vector<Footprint> footprints_;
  double widest_m_ = 0;
  double shallowest_m_ = 0;
  FloorShape floor_;
};

}  // namespace flair::optimizer
