// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "language_worker/handbook/rooms/openings.h"
#include "language_worker/handbook/rooms/wall_space.h"

namespace flair::language {

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
  bool IsBare(int wall) const;

  // Puts so many into a wall beside what it has; returns how many there was room for.
  int AddOn(int wall, const OpeningWish& wish, int count);
  bool HasOpening(int wall) const;
  // As the wish says or as is usual.
  OpeningSize SizeOf(const OpeningWish& wish, int wall) const;
  // Makes the remark on a wish of whose openings fewer were made than asked.
  void NoteFewer(const OpeningWish& wish, int made);
  std::vector<std::string> TakeRemarks() { return std::move(remarks_); }

 private:
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
