// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "flair/v1/constraint_list.pb.h"

namespace flair::language {

// Step D iii over any list, a model's as well: sentences that say two things about openings are split, fillers are cut,
// those that say the same of the same objects become one, and of two that contradict each other the weightier (else the
// earlier) stays. Every change is a step with its reason. Ids are never reused: changed sentences get ids of their own.
v1::ConstraintList CleanConstraints(const v1::ConstraintList& raw);

// What single sentences of a constraint list state.

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
  // Of kAtWall the side that is there, when it is none of back and front: in a corner two sides are at two walls.
  std::string side;
  // Largest distance for kNear, least for kAway, metres.
  double distance_m = 0;
};

// kNone for sentences that claim none of these.
Stance StanceOf(const v1::Sentence& sentence);

// Whether no layout can follow both: at a wall and in the middle of the room, near the window and away from it, within
// 1 m and at least 2 m away, facing and not facing, on the north wall and on the south wall.
bool Contradict(const Stance& a, const Stance& b);

}  // namespace flair::language
