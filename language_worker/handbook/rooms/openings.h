// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "flair/v1/room.pb.h"
#include "language_worker/handbook/choice.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/opening_reader.h"
#include "language_worker/handbook/rooms/walls.h"

namespace flair::language {

// What openings are to be made, after needs and themes had their say.
struct OpeningPlan {
  hb::OpeningRules rules;
  int window_count = 1;
  double door_width_m = 0.9;
  OpeningWishes asked;  // what the brief says of them; where it says nothing the rules decide
  // Walls that pieces are asked for at: others are better for what nobody asked for.
  std::vector<std::string> sides_of_pieces;
  // The brief tells walls from the door, perhaps "the left wall": they are those of the drawing where one comes in from
  // below.
  bool seen_from_the_door = false, left_and_right = false;
  // What shares a worktop is to be under a window: in a long room that is in a long wall.
  bool worktop_at_window = false;
  std::string room_type;  // "kitchen", of which "the kitchen door" is the door by which one comes in
};

// Adds a door near a corner, windows on other walls and sockets between them to a room whose floor, walls and height
// are set; all its corners are square. In a room that is no rectangle doors and windows keep to the outer walls, and a
// door to the end that is no re-entrant corner. Widths shrink to the walls. What the brief asks for stands where it
// says; returns sentences on what of it could not be had. Deterministic.
std::vector<std::string> AddOpenings(const OpeningPlan& plan, const Choice& choice, v1::Room& room);

// Puts what a brief says of doors and windows into a room, and says what could not be had, one sentence for each wish.
class AskedOpenings {
 public:
  // The arguments must outlive it.
  AskedOpenings(const OpeningPlan& plan, const Choice& choice, v1::Room& room)
      : plan_(plan), choice_(choice), room_(room), space_(room) {}

  // The door by which one comes in, where the brief speaks of it; else null.
  const OpeningWish* MainDoor() const;
  // Its wall, where the brief names one that the room has.
  std::optional<int> MainDoorWall() const;
  // Makes it there; false when there is no room for it.
  bool AddMainDoor(int wall, v1::DoorSwing swing);
  // Walls that hold openings that the brief asks for, as far as their words do not go by the door.
  std::set<int> WallsAskedFor() const;

  // The other doors, after the first one was made.
  void AddFurtherDoors();
  // Windows, after all doors: those with a wall; those without, unless they are all alike, so that the usual places do.
  void AddWindows();
  // Whether windows stand in their usual places, `plan().window_count` of them.
  bool UsualWindows() const;
  // Whether a wall is to have no window.
  bool IsBare(int wall) const { return AnyIs(plan_.asked.bare_sides, wall); }
  // Whether a piece is asked for at a wall.
  bool HasPiece(int wall) const { return AnyIs(plan_.sides_of_pieces, wall); }

  // Puts so many into a wall beside what it has; returns how many there was room for.
  int AddOn(int wall, const OpeningWish& wish, int count);
  // As the wish says or as is usual.
  OpeningSize SizeOf(const OpeningWish& wish, int wall) const;
  // Makes the remark on a wish of whose openings fewer were made than asked.
  void NoteFewer(const OpeningWish& wish, int made);
  std::vector<std::string> TakeRemarks() { return std::move(remarks_); }

 private:
  bool AnyIs(const std::vector<std::string>& sides, int wall) const;
  std::vector<int> WallsToTry(const OpeningWish& wish) const;
  void Make(int wall, const OpeningWish& wish, const WallSpan& span);
  AlongWall AlongOf(int wall, const OpeningWish& wish) const;
  std::vector<int> SharesOf(const std::vector<int>& walls, const OpeningWish& wish) const;
  void NoteNarrower(const OpeningWish& wish, int wall, double width_m, bool moved);

  const OpeningPlan& plan_;
  const Choice& choice_;
  v1::Room& room_;
  const WallSpace space_;
  std::vector<std::string> remarks_;
};

// Fills in a door's or window's id, kind and heights, after the plan's rules and what the wish says otherwise.
void SetDoor(const OpeningPlan& plan, const v1::Room& room, v1::Opening& door);
void SetWindow(const OpeningPlan& plan, const OpeningWish& wish, const v1::Room& room, v1::Opening& window);

}  // namespace flair::language
