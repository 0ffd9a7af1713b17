// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "language_worker/handbook/reading/words.h"
#include "language_worker/handbook/rooms/openings.h"
#include "language_worker/handbook/rooms/walls.h"

namespace flair::language {
namespace {

constexpr double kDoorCornerM = 0.1, kWindowCornerM = 0.3;
constexpr double kLeastDoorM = 0.6, kLeastWindowM = 0.4;
constexpr double kWideDoor = 1.3;    // a wide one by the usual
constexpr double kLeastPaneM = 0.3;  // from sill to head
constexpr double kLongWallM = 4.5;
constexpr double kPerWindowM = 2.4;   // of a wall
constexpr double kWholeWallM = 50;    // wider than any: "a wall of windows"
constexpr double kPaneM = 2.2;        // of windows that fill a wall
constexpr double kMostOfAWall = 0.7;  // that doors take up

double Usual(double value, double fallback) { return value > 0 ? value : fallback; }

int CountOf(v1::OpeningKind kind, const v1::Room& room) {
  return static_cast<int>(std::ranges::count_if(room.openings(), [&](const auto& one) { return one.kind() == kind; }));
}

// To a larder or a bathroom, by which nobody comes in.
bool LeadsNowhere(const OpeningWish& door) {
  const std::vector<Token> words = TokensOf(door.leads_to);
  return std::ranges::any_of(words, [](const Token& word) { return IsFormIn("dead_ends", word.text); });
}

std::string NameOf(const v1::Room& room, int wall) {
  const std::string& name = room.walls(wall).name();
  return name.starts_with("wall") ? name : name + " wall";
}

}  // namespace

void SetDoor(const OpeningPlan& plan, const v1::Room& room, v1::Opening& door) {
  door.set_id(fmt::format("door_{}", CountOf(v1::OPENING_KIND_DOOR, room) + 1));
  door.set_kind(v1::OPENING_KIND_DOOR);
  door.set_head_height_m(std::min(Usual(plan.rules.door_height_m(), 2.05), room.height_m()));
  door.mutable_leaf()->set_swing_angle_rad(std::numbers::pi / 2);
}

void SetWindow(const OpeningPlan& plan, const OpeningWish& wish, const v1::Room& room, v1::Opening& window) {
  window.set_id(fmt::format("window_{}", CountOf(v1::OPENING_KIND_WINDOW, room) + 1));
  window.set_kind(v1::OPENING_KIND_WINDOW);
  double head_m = std::min(Usual(plan.rules.window_head_m(), 2.1), room.height_m());
  double sill_m = wish.sill_m.value_or(Usual(plan.rules.window_sill_m(), 0.9));
  if (wish.height_m) head_m = sill_m + *wish.height_m;
  if (wish.to_ceiling) head_m = room.height_m();
  head_m = std::min(std::max(head_m, wish.sill_m ? sill_m + kLeastPaneM : head_m), room.height_m());
  if (wish.height_m) sill_m = std::max(0.0, std::min(sill_m, head_m - *wish.height_m));
  window.set_head_height_m(head_m);
  window.set_sill_height_m(std::min(sill_m, head_m - kLeastPaneM));
}

const OpeningWish* AskedOpenings::MainDoor() const {
  const OpeningWish *main = nullptr, *through_a_room = nullptr, *any = nullptr;
  int doors = 0;
  for (const OpeningWish& one : plan_.asked.wishes) {
    if (!one.door) continue;
    doors += one.count;
    if (any == nullptr) any = &one;
    // "Three doors on the right" are seen from another one.
    const bool seen = one.side != "near" && GoesByTheDoor(one.side);
    if (one.outside || (seen && one.count > 1)) continue;
    if (one.leads_to.empty() || plan_.room_type.find(one.leads_to) != std::string::npos) {
      if (main == nullptr || (GoesByTheDoor(main->side) && !seen)) main = &one;
    } else if (through_a_room == nullptr && one.swing != v1::DOOR_SWING_NONE && !LeadsNowhere(one)) {
      through_a_room = &one;
    }
  }
  if (main != nullptr) return main;
  // Where the brief lists the doors, one comes in by one of them.
  if (doors > 1 && through_a_room != nullptr) return through_a_room;
  return plan_.asked.other_way_in ? any : nullptr;
}

std::optional<int> AskedOpenings::MainDoorWall() const {
  const OpeningWish* wish = MainDoor();
  return wish == nullptr || wish->side.empty() ? std::nullopt : WallOf(room_, wish->side);
}

bool AskedOpenings::AddMainDoor(int wall, v1::DoorSwing swing) {
  OpeningWish wish = *MainDoor();
  if (wish.swing == v1::DOOR_SWING_UNSPECIFIED) wish.swing = swing;
  return AddOn(wall, wish, 1) == 1;
}

std::set<int> AskedOpenings::WallsAskedFor() const {
  std::set<int> walls;
  for (const OpeningWish& wish : plan_.asked.wishes) {
    if (wish.side.empty() || GoesByTheDoor(wish.side) || &wish == MainDoor()) continue;
    if (const std::optional<int> wall = WallOf(room_, wish.side)) walls.insert(*wall);
  }
  return walls;
}

void AskedOpenings::AddFurtherDoors() {
  const OpeningWish* main = MainDoor();
  for (const OpeningWish& wish : plan_.asked.wishes) {
    if (!wish.door) continue;
    const int asked = &wish == main ? wish.count - 1 : wish.count;
    int left = asked;
    for (const int wall : WallsToTry(wish)) {
      // On different walls where the brief does not say.
      if (left > 0) left -= AddOn(wall, wish, wish.side.empty() ? 1 : left);
    }
    NoteFewer(wish, wish.count - left);
  }
}

bool AskedOpenings::UsualWindows() const {
  constexpr int kMostUsual = 3;
  int wishes = 0;
  for (const OpeningWish& wish : plan_.asked.wishes) {
    if (wish.door) continue;
    if (!wish.side.empty() || wish.along.at != AlongWall::At::kAny || wish.count > kMostUsual) return false;
    ++wishes;
  }
  return wishes <= 1;
}

void AskedOpenings::AddWindows() {
  bool of_many = true;
  // Those whose wall is said come first, and take their pick of it.
  for (const bool placed : {true, false}) {
    for (const OpeningWish& wish : plan_.asked.wishes) {
      if (wish.door || wish.side.empty() == placed) continue;
      of_many = of_many && wish.of_many;
      const std::vector<int> walls = WallsToTry(wish);
      const std::vector<int> shares = SharesOf(walls, wish);
      int left = wish.count;
      for (std::size_t w = 0; w < walls.size(); ++w) left -= AddOn(walls[w], wish, shares[w]);
      if (wish.counted || left == wish.count) NoteFewer(wish, wish.count - left);
    }
  }
  if (!of_many) return;
  OpeningWish rest;
  int left = plan_.window_count - CountOf(v1::OPENING_KIND_WINDOW, room_);
  for (const int wall : WallsToTry(rest)) {
    if (left > 0 && IsBlank(room_, wall)) left -= AddOn(wall, rest, 1);
  }
}

// How many of a wish go into each wall: in turns, as long as there is room.
std::vector<int> AskedOpenings::SharesOf(const std::vector<int>& walls, const OpeningWish& wish) const {
  std::vector<int> shares(walls.size(), 0);
  if (walls.size() == 1) {
    // "Windows along the east wall" fill a long one.
    const int fitting = static_cast<int>(WallLength(room_, walls[0]) / kPerWindowM);
    shares[0] = wish.counted || wish.count < 2 ? wish.count : std::max(wish.count, fitting);
    return shares;
  }
  int left = wish.count;
  for (bool any = true; any && left > 0;) {
    any = false;
    for (std::size_t w = 0; w < walls.size() && left > 0; ++w) {
      if (shares[w] > 0 && (shares[w] + 1) * kPerWindowM > WallLength(room_, walls[w])) continue;
      // The wall with the door comes last.
      if (!IsBlank(room_, walls[w]) && shares[w] > 0 && shares[w] * 2 * kPerWindowM > WallLength(room_, walls[w]))
        continue;
      ++shares[w];
      --left;
      any = true;
    }
  }
  return shares;
}

bool AskedOpenings::AnyIs(const std::vector<std::string>& sides, int wall) const {
  return std::ranges::any_of(sides, [&](const std::string& side) { return WallOf(room_, side) == wall; });
}

void AskedOpenings::NoteFewer(const OpeningWish& wish, int made) {
  if (made >= wish.count) return;
  const std::optional<int> wall = wish.side.empty() ? std::nullopt : WallOf(room_, wish.side);
  std::string why = "the walls have room for no more";
  if (!wish.side.empty()) {
    why = wall
              ? fmt::format("the {}, {:g} m long, has room for no more", NameOf(room_, *wall), WallLength(room_, *wall))
              : "the room has no such wall";
  }
  remarks_.push_back(fmt::format("\"{}\": {} of {} made; {}.", wish.said, made, wish.count, why));
}

// The wall that is said; else those across from the door and beside it, empty ones first.
std::vector<int> AskedOpenings::WallsToTry(const OpeningWish& wish) const {
  std::vector<int> walls;
  if (!wish.side.empty()) {
    const std::optional<int> wall = WallOf(room_, wish.side);
    if (!wall) return walls;
    // "On the long wall": of the two the one that has nothing yet.
    const std::optional<int> other = WallOf(room_, "across " + wish.side);
    const bool either = (wish.side.starts_with("long") || wish.side.starts_with("short")) && other &&
                        !IsBlank(room_, *wall) && IsBlank(room_, *other) &&
                        WallLength(room_, *other) == WallLength(room_, *wall);
    walls.push_back(either ? *other : *wall);
    return walls;
  }
  for (const bool empty : {true, false}) {
    for (const char* side : {"far", "left", "right", "near"}) {
      const std::optional<int> wall = WallOf(room_, side);
      if (!wall || (!wish.door && IsBare(*wall))) continue;
      if (IsBlank(room_, *wall) == empty) walls.push_back(*wall);
    }
  }
  return walls;
}

OpeningSize AskedOpenings::SizeOf(const OpeningWish& wish, int wall) const {
  if (wish.door) {
    const double usual_m = plan_.door_width_m * (wish.width_factor > 1 ? kWideDoor : wish.width_factor < 1 ? 0.8 : 1);
    const double most_m = wish.fills ? kMostOfAWall * WallLength(room_, wall) : usual_m;
    return {wish.width_m.value_or(std::max(usual_m, most_m)), kLeastDoorM, kDoorCornerM};
  }
  double usual_m = Usual(plan_.rules.window_width_m(), 1.2);
  if (wish.count == 1 && WallLength(room_, wall) > kLongWallM)
    usual_m = std::max(usual_m, std::min(1.8, usual_m * 1.5));
  const double width_m = wish.width_m.value_or(usual_m * wish.width_factor);
  return {width_m, std::min(kLeastWindowM, width_m), kWindowCornerM};
}

// Puts so many into a wall; returns how many there was room for.
int AskedOpenings::AddOn(int wall, const OpeningWish& wish, int count) {
  if (count <= 0) return 0;
  const OpeningSize size = SizeOf(wish, wall);
  bool moved = false;
  std::vector<WallSpan> spans;
  const bool whole = wish.width_m && *wish.width_m > kWholeWallM;
  const bool fills = !wish.door && (whole || wish.fills);
  if (fills) {
    spans = space_.Fill(wall, whole ? *wish.width_m : wish.counted ? WallLength(room_, wall) / count : kPaneM, size);
  } else if (count == 1) {
    if (const auto span = space_.Place(wall, size, AlongOf(wall, wish), moved)) spans.push_back(*span);
  } else {
    spans = space_.Spread(wall, count, size);
  }
  for (const WallSpan& span : spans) Make(wall, wish, span);
  if (!spans.empty()) NoteNarrower(wish, wall, spans.front().width_m, moved);
  return fills && !spans.empty() ? count : static_cast<int>(spans.size());
}

void AskedOpenings::Make(int wall, const OpeningWish& wish, const WallSpan& span) {
  v1::Opening opening;
  if (wish.door) {
    SetDoor(plan_, room_, opening);
    // The leaf rests on the side wall that is nearer. A further door leaves the room's floor alone.
    const bool at_end = span.offset_m + span.width_m / 2 > WallLength(room_, wall) / 2 + 1e-9;
    opening.mutable_leaf()->set_hinge(at_end ? v1::HINGE_SIDE_END : v1::HINGE_SIDE_START);
    opening.mutable_leaf()->set_swing(wish.swing == v1::DOOR_SWING_UNSPECIFIED ? v1::DOOR_SWING_OUTWARD : wish.swing);
  } else {
    SetWindow(plan_, wish, room_, opening);
  }
  opening.set_description(wish.name);
  opening.set_wall(room_.walls(wall).name());
  opening.set_offset_m(span.offset_m);
  opening.set_width_m(span.width_m);
  *room_.add_openings() = opening;
}

// An end that the words leave open is chosen by the seed, for the door as for one that nobody places.
AlongWall AskedOpenings::AlongOf(int wall, const OpeningWish& wish) const {
  AlongWall along = wish.along;
  if (along.at != AlongWall::At::kEnd || space_.IsEnd(wall, along.end)) return along;
  const bool at_end = choice_.Index("door.end", 2) == 1;
  for (const char* side : {"left", "right"}) {
    if (space_.IsEnd(wall, side) == std::optional<bool>(at_end)) along.end = side;
  }
  return along;
}

void AskedOpenings::NoteNarrower(const OpeningWish& wish, int wall, double width_m, bool moved) {
  if (wish.width_m && *wish.width_m < kWholeWallM && width_m < *wish.width_m - 1e-9) {
    remarks_.push_back(fmt::format("\"{}\": {:g} m wide instead of {:g} m; the {}, {:g} m long, has room for no more.",
                                   wish.said, width_m, *wish.width_m, NameOf(room_, wall), WallLength(room_, wall)));
  } else if (moved) {
    remarks_.push_back(
        fmt::format("\"{}\": it is placed elsewhere in the {}, where there is room.", wish.said, NameOf(room_, wall)));
  }
}

}  // namespace flair::language
