// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "flair/v1/room.pb.h"
#include "language_worker/handbook/choosing/choice.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/opening_wish.h"

namespace flair::language {

// What openings are to be made, after needs and themes had their say.
struct OpeningPlan {
  hb::OpeningRules rules;
  int window_count = 1;
  double door_width_m = 0.9;
  OpeningWishes asked;    // what the brief says of them; where it says nothing the rules decide
  std::string room_type;  // "kitchen", of which "the kitchen door" is the door by which one comes in
};

// Adds a door near a corner, windows on other walls and sockets between them to a room whose floor, walls and height
// are set; all its corners are square. In a room that is no rectangle doors and windows keep to the outer walls, and a
// door to the end that is no re-entrant corner. Widths shrink to the walls. What the brief asks for stands where it
// says; returns sentences on what of it could not be had. Deterministic.
std::vector<std::string> AddOpenings(const OpeningPlan& plan, const Choice& choice, v1::Room& room);

}  // namespace flair::language
