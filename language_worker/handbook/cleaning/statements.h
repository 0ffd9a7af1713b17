// SPDX-License-Identifier: GPL-3.0-or-later
// What single sentences of a constraint list state.
#pragma once

#include <string>
#include <vector>

#include "flair/v1/constraint_list.pb.h"

namespace flair::language {

// The single statements of a sentence that says several things, in order; the sentence alone when it says one:
//   "The bed does not block doors or windows."           -> about doors; about windows
//   "The desk is against a wall and near a socket."      -> "... is against a wall."; "The desk is near a socket."
//   "The sofa faces the window and has its back to us."  -> "... faces the window."; "The sofa has its back to us."
//   "Keep the door free; leave space around the bed."    -> both
std::vector<std::string> SplitStatements(const std::string& text);

// What a sentence claims about where its first subject is, as far as contradictions go.
struct Stance {
  enum class Kind { kNone, kAtWall, kOffWalls, kCentral, kInCorner, kNear, kAway, kFacing, kNotFacing };
  Kind kind = Kind::kNone;
  // Who: the first subject id.
  std::string subject;
  // Of what: "window", "door", "socket", a named wall such as "north wall", or the id of the second subject.
  std::string partner;
  // Largest distance for kNear, least for kAway, metres.
  double distance_m = 0;
};

// kNone for sentences that claim none of these.
Stance StanceOf(const v1::Sentence& sentence);

// Whether no layout can follow both: at a wall and in the middle of the room, near the window and away from it, within
// 1 m and at least 2 m away, facing and not facing, on the north wall and on the south wall.
bool Contradict(const Stance& a, const Stance& b);

}  // namespace flair::language
