// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/rooms/openings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "language_worker/handbook/objects/fit_floor.h"
#include "language_worker/handbook/rooms/describe_room.h"

namespace flair::language {
namespace {

constexpr double kCornerGapM = 0.3;  // of windows
constexpr double kSocketGapM = 0.35;
constexpr double kShortWallM = 2.4;
constexpr double kLongRoom = 1.3;  // longer by shorter side

double Or(double value, double fallback) { return value > 0 ? value : fallback; }
double RoundDown(double length_m) { return std::floor(length_m * 20 + 1e-9) / 20; }

class OpeningMaker {
 public:
  OpeningMaker(const OpeningPlan& plan, const Choice& choice, v1::Room& room)
      : plan_(plan), choice_(choice), room_(room), asked_(plan, choice, room) {
    for (int i = 0; i < room.floor().vertices_size(); ++i) lengths_.push_back(WallLength(room, i));
  }

  std::vector<std::string> Make() {
    AddDoor();
    asked_.AddFurtherDoors();
    if (asked_.UsualWindows()) {
      AddWindows();
    } else {
      asked_.AddWindows();
    }
    AddSockets();
    return asked_.TakeRemarks();
  }

 private:
  // That which the brief names; else one that it names for no other opening.
  std::size_t DoorWall() const {
    if (const std::optional<int> wall = asked_.MainDoorWall()) return static_cast<std::size_t>(*wall);
    const std::size_t usual = UsualDoorWall();
    std::set<int> taken = asked_.WallsAskedFor();
    for (int wall = 0; wall < static_cast<int>(lengths_.size()); ++wall) {
      if (asked_.HasPiece(wall)) taken.insert(wall);
    }
    // A long room is entered by a short wall, but for left and right.
    const bool broad = !plan_.left_and_right && lengths_.size() == 4 && lengths_[0] > kLongRoom * lengths_[1];
    const std::optional<int> below = plan_.seen_from_the_door && !broad ? WallOf(room_, "south") : std::nullopt;
    if (below && !taken.contains(*below)) return static_cast<std::size_t>(*below);
    for (const std::size_t turn : {0u, 2u, 1u, 3u}) {
      const std::size_t wall = (usual + turn) % lengths_.size();
      const bool long_enough = turn == 0 || lengths_[wall] >= plan_.door_width_m + 0.4;
      if (long_enough && !taken.contains(static_cast<int>(wall))) return wall;
    }
    return usual;
  }

  // The door stands in one of the short walls of a long room, in any wall of others.
  std::size_t UsualDoorWall() const {
    if (lengths_.size() != 4) return DoorWallOfPolygon();
    const double ratio = lengths_[0] / lengths_[1];
    const std::size_t turn = choice_.Index("door.wall", 2) * 2;
    if (ratio > kLongRoom) return 1 + turn;
    if (ratio < 1 / kLongRoom) return turn;
    return choice_.Index("door.any_wall", 4);
  }

  // Any wall with room for the door and its leaf, on the outside of the room's rectangle rather than in its notches.
  std::size_t DoorWallOfPolygon() const {
    std::vector<std::size_t> walls;
    for (const bool outside : {true, false}) {
      for (std::size_t wall = 0; wall < lengths_.size() && (outside || walls.empty()); ++wall) {
        if (lengths_[wall] >= plan_.door_width_m + 0.4 && (!outside || IsOutside(wall))) walls.push_back(wall);
      }
    }
    if (walls.empty()) return static_cast<std::size_t>(WallOf(room_, "long").value_or(0));
    return walls[choice_.Index("door.any_wall", walls.size())];
  }

  // Whether a wall lies on the bounding rectangle.
  bool IsOutside(std::size_t wall) const {
    const v1::Point2 from = PointOn(room_, static_cast<int>(wall), 0);
    const v1::Point2 to = PointOn(room_, static_cast<int>(wall), lengths_[wall]);
    const FloorExtent extent = ExtentOf(room_);
    const bool along_x = from.y_m() == to.y_m();
    const double at_m = along_x ? from.y_m() : from.x_m();
    return at_m == 0 || at_m == (along_x ? extent.depth_m : extent.width_m);
  }

  // Quarter turns, counter-clockwise, from the door's wall to another: 2 for one that faces it.
  std::size_t TurnsTo(std::size_t wall) const {
    const int turns = HeadingOf(room_, static_cast<int>(wall)) - HeadingOf(room_, static_cast<int>(door_wall_));
    return static_cast<std::size_t>((turns + 4) % 4);
  }

  void AddDoor() {
    door_wall_ = DoorWall();
    const OpeningWish* wish = asked_.MainDoor();
    const bool placed = wish != nullptr && (wish->along.at != AlongWall::At::kAny || wish->width_m);
    if (placed && asked_.AddMainDoor(static_cast<int>(door_wall_), UsualSwing())) return;
    const double wall_m = lengths_[door_wall_];
    const double usual_m =
        wish == nullptr ? plan_.door_width_m : asked_.SizeOf(*wish, static_cast<int>(door_wall_)).width_m;
    const double width_m = std::min(usual_m, RoundDown(wall_m - 0.2));
    // A short wall leaves no room beside a door that stands further in.
    const double near_m = wall_m < kShortWallM ? 0.1 : choice_.Stepped("door.gap", 0.2, 0.5, 0.05);
    double offset_m = std::min(near_m, (wall_m - width_m) / 2);
    const bool central = plan_.rules.door_central() && wall_m > width_m + 2 && !HasOneWindowBeside();
    const bool flanked = std::ranges::any_of(plan_.asked.wishes, &OpeningWish::flanks);
    if (central || flanked || IsOneOfManySides()) offset_m = (wall_m - width_m) / 2;
    bool at_end = choice_.Index("door.end", 2) == 1;
    // A door at a corner that the room goes round would open into the way.
    const bool round_start = IsReentrant(room_, static_cast<int>(door_wall_));
    if (round_start != IsReentrant(room_, static_cast<int>(door_wall_ + 1))) at_end = round_start;
    if (at_end) offset_m = wall_m - width_m - offset_m;
    v1::Opening& door = *room_.add_openings();
    SetDoor(plan_, room_, door);
    door.set_wall(room_.walls(static_cast<int>(door_wall_)).name());
    door.set_offset_m(offset_m);
    door.set_width_m(width_m);
    if (wish != nullptr) door.set_description(wish->name);
    // The leaf rests on the side wall that is nearer.
    door.mutable_leaf()->set_hinge(at_end ? v1::HINGE_SIDE_END : v1::HINGE_SIDE_START);
    const bool asked = wish != nullptr && wish->swing != v1::DOOR_SWING_UNSPECIFIED;
    door.mutable_leaf()->set_swing(asked ? wish->swing : UsualSwing());
  }

  // Of an octagon or a round room.
  bool IsOneOfManySides() const {
    bool convex = lengths_.size() > 4;
    for (std::size_t i = 0; i < lengths_.size(); ++i) convex = convex && !IsReentrant(room_, static_cast<int>(i));
    return convex;
  }

  // Which leaves the door no place in the middle.
  bool HasOneWindowBeside() const {
    int count = 0;
    for (const OpeningWish& wish : plan_.asked.wishes) {
      const bool there = IsIn("near_walls", wish.side) || WallOf(room_, wish.side) == static_cast<int>(door_wall_);
      if (!wish.door && there) count += wish.count;
    }
    return count == 1;
  }

  v1::DoorSwing UsualSwing() const {
    const bool passage = choice_.Happens("door.passage", plan_.rules.passage_chance());
    if (passage || plan_.asked.no_doors) return v1::DOOR_SWING_NONE;
    return FloorArea(room_) < plan_.rules.door_outward_below_m2() ? v1::DOOR_SWING_OUTWARD : v1::DOOR_SWING_INWARD;
  }

  // Opposite the door first, then the walls beside it; a wall takes a second window when it is long.
  void AddWindows() {
    const std::size_t beside = choice_.Index("window.beside", 2) == 0 ? 1 : 3;
    const double ratio = lengths_[(door_wall_ + 1) % lengths_.size()] / lengths_[door_wall_];
    const bool side_first = choice_.Happens("window.side_first", 0.3) || (plan_.worktop_at_window && ratio > kLongRoom);
    std::vector<std::size_t> turns = {2, beside, 4 - beside};
    if (side_first) std::swap(turns[0], turns[1]);
    std::vector<std::size_t> order = WallsInOrder(turns);
    int left = plan_.window_count;
    // Nobody asked for one behind a piece.
    const auto has_piece = [&](std::size_t wall) { return asked_.HasPiece(static_cast<int>(wall)); };
    if (!WindowWish().counted && !std::ranges::all_of(order, has_piece)) std::erase_if(order, has_piece);
    const bool one_wall = plan_.asked.one_window_wall || plan_.rules.one_window_wall();
    if (one_wall && order.size() > 1) {
      std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return lengths_[a] > lengths_[b]; });
      order.resize(1);
    }
    for (const std::size_t wall : order) {
      // The first wall takes what the two others, with one window each, do not.
      const int room_for = std::max(1, static_cast<int>((lengths_[wall] - kCornerGapM) / 2.4));
      const int others = one_wall ? 0 : 2;
      const int count = wall == order[0] ? std::clamp(left - others, std::min(left, 1), room_for) : std::min(left, 1);
      if (count > 0) AddWindowsOn(wall, count);
      left -= count;
    }
    for (const OpeningWish& wish : plan_.asked.wishes) {
      if (!wish.door && wish.counted)
        asked_.NoteFewer(
            wish, static_cast<int>(std::ranges::count(room_.openings(), v1::OPENING_KIND_WINDOW, &v1::Opening::kind)));
    }
  }

  // The longest outer wall of each turn; then the other outer walls with room for a window.
  std::vector<std::size_t> WallsInOrder(const std::vector<std::size_t>& turns) const {
    std::vector<std::size_t> order, others;
    for (const std::size_t turn : turns) {
      std::size_t best = lengths_.size();
      for (std::size_t wall = 0; wall < lengths_.size(); ++wall) {
        if (wall == door_wall_ || TurnsTo(wall) != turn || !IsOutside(wall)) continue;
        if (asked_.IsBare(static_cast<int>(wall))) continue;
        if (best < lengths_.size() && lengths_[wall] > 1.5)
          others.push_back(lengths_[wall] > lengths_[best] ? best : wall);
        if (best == lengths_.size() || lengths_[wall] > lengths_[best]) best = wall;
      }
      if (best < lengths_.size()) order.push_back(best);
    }
    order.insert(order.end(), others.begin(), others.end());
    // Those with a further door last.
    std::ranges::stable_partition(order, [&](std::size_t wall) { return IsBlank(room_, static_cast<int>(wall)); });
    return order;
  }

  void AddWindowsOn(std::size_t wall, int count) {
    if (!IsBlank(room_, static_cast<int>(wall))) {
      asked_.AddOn(static_cast<int>(wall), WindowWish(), count);
      return;
    }
    const double wall_m = lengths_[wall];
    const double share_m = wall_m / count;
    double width_m = std::min(UsualWindowWidth(), RoundDown(share_m - 2 * kCornerGapM));
    const bool wide = count == 1 && wall_m > 4.5 && !WindowWish().width_m && WindowWish().width_factor == 1;
    if (wide) width_m = std::max(width_m, std::min(1.8, width_m * 1.5));
    if (width_m < 0.3) return;
    constexpr std::array<double, 5> kPlaces = {0.5, 0.5, 0.5, 0.3, 0.7};
    for (int i = 0; i < count; ++i) {
      const double place =
          count > 1 ? 0.5 : kPlaces[choice_.Index(fmt::format("window.place.{}", wall), kPlaces.size())];
      const double middle_m = share_m * (i + place);
      v1::Opening window;
      SetWindow(plan_, WindowWish(), room_, window);
      window.set_wall(room_.walls(static_cast<int>(wall)).name());
      window.set_offset_m(std::clamp(middle_m - width_m / 2, kCornerGapM, wall_m - kCornerGapM - width_m));
      window.set_width_m(width_m);
      *room_.add_openings() = window;
    }
  }

  double UsualWindowWidth() const {
    const double usual_m = Or(plan_.rules.window_width_m(), 1.2) * WindowWish().width_factor;
    return WindowWish().width_m.value_or(usual_m);
  }

  // What the brief says of all of them.
  const OpeningWish& WindowWish() const {
    static const OpeningWish kNone;
    const auto& all = plan_.asked.wishes;
    const auto found = std::ranges::find_if(all, [](const OpeningWish& one) { return !one.door; });
    return found == all.end() ? kNone : *found;
  }

  // Spread over the walls, near their ends, where no opening is.
  void AddSockets() {
    const int wanted = plan_.rules.socket_count() > 0 ? plan_.rules.socket_count() : 3;
    for (int i = 0; i < wanted * 3 && room_.sockets_size() < wanted; ++i) {
      const std::size_t wall = (door_wall_ + 1 + static_cast<std::size_t>(i)) % lengths_.size();
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
    return std::ranges::any_of(room_.openings(), [&](const v1::Opening& one) {
      return one.kind() == v1::OPENING_KIND_DOOR && one.wall() == room_.walls(static_cast<int>(wall)).name() &&
             offset_m > one.offset_m() - 0.1 && offset_m < one.offset_m() + one.width_m() + 0.1;
    });
  }

  const OpeningPlan& plan_;
  const Choice& choice_;
  v1::Room& room_;
  std::vector<double> lengths_;
  std::size_t door_wall_ = 0;
  AskedOpenings asked_;
};

}  // namespace

std::vector<std::string> AddOpenings(const OpeningPlan& plan, const Choice& choice, v1::Room& room) {
  return OpeningMaker(plan, choice, room).Make();
}

}  // namespace flair::language
