// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/rooms/openings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace flair::language {
namespace {

constexpr double kCornerGapM = 0.3;  // of windows
constexpr double kSocketGapM = 0.35;
constexpr double kShortWallM = 2.4;

double Or(double value, double fallback) { return value > 0 ? value : fallback; }
double RoundDown(double length_m) { return std::floor(length_m * 20 + 1e-9) / 20; }

class OpeningMaker {
 public:
  OpeningMaker(const OpeningPlan& plan, const Choice& choice, v1::Room& room)
      : plan_(plan), choice_(choice), room_(room) {
    lengths_ = {room.floor().vertices(1).x_m(), room.floor().vertices(2).y_m(), room.floor().vertices(1).x_m(),
                room.floor().vertices(2).y_m()};
  }

  void Make() {
    AddDoor();
    AddWindows();
    AddSockets();
  }

 private:
  // The door stands in one of the short walls of a long room, in any wall of others.
  std::size_t DoorWall() const {
    const double ratio = lengths_[0] / lengths_[1];
    const std::size_t turn = choice_.Index("door.wall", 2) * 2;
    if (ratio > 1.3) return 1 + turn;
    if (ratio < 1 / 1.3) return turn;
    return choice_.Index("door.any_wall", 4);
  }

  void AddDoor() {
    door_wall_ = DoorWall();
    const double wall_m = lengths_[door_wall_];
    const double width_m = std::min(plan_.door_width_m, RoundDown(wall_m - 0.2));
    // A short wall leaves no room beside a door that stands further in.
    const double near_m = wall_m < kShortWallM ? 0.1 : choice_.Stepped("door.gap", 0.2, 0.5, 0.05);
    double offset_m = std::min(near_m, (wall_m - width_m) / 2);
    if (plan_.rules.door_central() && wall_m > width_m + 2) offset_m = (wall_m - width_m) / 2;
    const bool at_end = choice_.Index("door.end", 2) == 1;
    if (at_end) offset_m = wall_m - width_m - offset_m;
    v1::Opening& door = *room_.add_openings();
    door.set_id("door_1");
    door.set_kind(v1::OPENING_KIND_DOOR);
    door.set_wall(room_.walls(static_cast<int>(door_wall_)).name());
    door.set_offset_m(offset_m);
    door.set_width_m(width_m);
    door.set_head_height_m(std::min(Or(plan_.rules.door_height_m(), 2.05), room_.height_m()));
    // The leaf rests on the side wall that is nearer.
    door.mutable_leaf()->set_hinge(at_end ? v1::HINGE_SIDE_END : v1::HINGE_SIDE_START);
    door.mutable_leaf()->set_swing_angle_rad(std::numbers::pi / 2);
    const double area_m2 = lengths_[0] * lengths_[1];
    v1::DoorSwing swing =
        area_m2 < plan_.rules.door_outward_below_m2() ? v1::DOOR_SWING_OUTWARD : v1::DOOR_SWING_INWARD;
    if (choice_.Happens("door.passage", plan_.rules.passage_chance())) swing = v1::DOOR_SWING_NONE;
    door.mutable_leaf()->set_swing(swing);
    door_.first = offset_m;
    door_.second = offset_m + width_m;
  }

  // Opposite the door first, then the walls beside it; a wall takes a second window when it is long.
  void AddWindows() {
    const std::size_t beside = choice_.Index("window.beside", 2) == 0 ? 1 : 3;
    const bool side_first = choice_.Happens("window.side_first", 0.3);
    std::vector<std::size_t> order = {2, beside, 4 - beside};
    if (side_first) std::swap(order[0], order[1]);
    int left = plan_.window_count;
    for (const std::size_t turn : order) {
      const std::size_t wall = (door_wall_ + turn) % 4;
      // The first wall takes what the two others, with one window each, do not.
      const int room_for = std::max(1, static_cast<int>((lengths_[wall] - kCornerGapM) / 2.4));
      const int count = turn == order[0] ? std::clamp(left - 2, std::min(left, 1), room_for) : std::min(left, 1);
      if (count > 0) AddWindowsOn(wall, count);
      left -= count;
    }
  }

  void AddWindowsOn(std::size_t wall, int count) {
    const double wall_m = lengths_[wall];
    const double share_m = wall_m / count;
    double width_m = std::min(Or(plan_.rules.window_width_m(), 1.2), RoundDown(share_m - 2 * kCornerGapM));
    if (count == 1 && wall_m > 4.5) width_m = std::max(width_m, std::min(1.8, width_m * 1.5));
    if (width_m < 0.3) return;
    constexpr std::array<double, 5> kPlaces = {0.5, 0.5, 0.5, 0.3, 0.7};
    for (int i = 0; i < count; ++i) {
      const double place =
          count > 1 ? 0.5 : kPlaces[choice_.Index(fmt::format("window.place.{}", wall), kPlaces.size())];
      const double middle_m = share_m * (i + place);
      v1::Opening& window = *room_.add_openings();
      window.set_id(fmt::format("window_{}", room_.openings_size() - 1));
      window.set_kind(v1::OPENING_KIND_WINDOW);
      window.set_wall(room_.walls(static_cast<int>(wall)).name());
      window.set_offset_m(std::clamp(middle_m - width_m / 2, kCornerGapM, wall_m - kCornerGapM - width_m));
      window.set_width_m(width_m);
      const double head_m = std::min(Or(plan_.rules.window_head_m(), 2.1), room_.height_m());
      window.set_head_height_m(head_m);
      window.set_sill_height_m(std::min(Or(plan_.rules.window_sill_m(), 0.9), head_m - 0.3));
    }
  }

  // Spread over the walls, near their ends, where no opening is.
  void AddSockets() {
    const int wanted = plan_.rules.socket_count() > 0 ? plan_.rules.socket_count() : 3;
    for (int i = 0; i < wanted * 3 && room_.sockets_size() < wanted; ++i) {
      const std::size_t wall = (door_wall_ + 1 + static_cast<std::size_t>(i)) % 4;
      const double share = choice_.Stepped(fmt::format("socket.{}", i), 0.15, 0.9, 0.05);
      const double offset_m = kSocketGapM + share * (lengths_[wall] - 2 * kSocketGapM);
      if (lengths_[wall] < 3 * kSocketGapM || IsOpen(wall, offset_m)) continue;
      v1::Socket& socket = *room_.add_sockets();
      socket.set_id(fmt::format("socket_{}", room_.sockets_size()));
      socket.set_wall(room_.walls(static_cast<int>(wall)).name());
      socket.set_offset_m(offset_m);
      socket.set_height_m(Or(plan_.rules.socket_height_m(), 0.45));
    }
  }

  bool IsOpen(std::size_t wall, double offset_m) const {
    return wall == door_wall_ && offset_m > door_.first - 0.1 && offset_m < door_.second + 0.1;
  }

  const OpeningPlan& plan_;
  const Choice& choice_;
  v1::Room& room_;
  std::array<double, 4> lengths_;
  std::size_t door_wall_ = 0;
  std::pair<double, double> door_;
};

}  // namespace

void AddOpenings(const OpeningPlan& plan, const Choice& choice, v1::Room& room) {
  OpeningMaker(plan, choice, room).Make();
}

}  // namespace flair::language
