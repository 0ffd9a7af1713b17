// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "flair/v1/room.pb.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// Where along its wall an opening stands, as far as a brief says.
struct AlongWall {
  enum class At { kAny, kMiddle, kEnd };
  At at = At::kAny;
  std::string end;                   // of kEnd which: "left", "north", "door"; empty for either
  std::optional<double> from_end_m;  // of kEnd how far from it
};

// Doors or windows that a brief asks for: "two windows on the east wall", "a 90 cm door in the middle of the south
// wall".
struct OpeningWish {
  bool door = false;
  int count = 1;
  bool counted = false;   // a number or an article says how many
  bool definite = false;  // "the door": perhaps one that was named before
  std::string side;       // words for its wall, see WallOf; empty where none is said
  AlongWall along;
  std::optional<double> width_m;
  std::optional<double> height_m;
  std::optional<double> sill_m;
  double width_factor = 1;  // on what is usual: "large", "small"
  bool to_ceiling = false;
  bool outside = false;  // to a garden or balcony: not the door by which one comes in
  std::string leads_to;  // "kitchen"; empty where the brief does not say, or where one comes in by it
  std::string name;      // "kitchen hatch", "street door", "secret door"; empty where nothing tells it from others
  bool flanks = false;   // the door: "a window on either side of it"
  bool fills = false;    // its wall: "windows all along the south"
  v1::DoorSwing swing = v1::DOOR_SWING_UNSPECIFIED;
  std::string kind;      // "bay window", where it cannot be drawn as what it is
  bool of_many = false;  // the room has the usual other ones too: "a south-facing room"
  std::string said;
};

// What a brief says of all openings.
struct OpeningWishes {
  std::vector<OpeningWish> wishes;
  bool no_windows = false;
  bool no_doors = false;
  bool window_meant = false;            // "a desk under the window": there is one
  bool windows_meant = false;           // "by the windows": there are several
  bool one_window_wall = false;         // "the window wall": the others have none
  bool other_way_in = false;            // "a trapdoor as the only entrance": no further door is needed
  std::vector<std::string> bare_sides;  // "no windows on the north wall"
  std::vector<std::string> not_read;    // sentences on what cannot be made or was not understood
};

// Reads what a brief says of doors and windows, and marks the tokens that it has used. Words that only tell where a
// piece goes ("by the window") are no wishes, but what they say of the window's own place is one: "by the window in the
// north wall". `room` are the tokens that name the kind of room, `used` those and the ones that name furniture.
void ReadOpenings(const std::vector<Token>& tokens, const std::vector<bool>& room, std::vector<bool>& used,
                  OpeningWishes& openings);

}  // namespace flair::language
