// SPDX-License-Identifier: GPL-3.0-or-later
// Units in a run along walls, such as a kitchen's: one worktop without gaps, on one wall, round a corner or on two
// walls that face each other.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "flair/v1/object_list.pb.h"
#include "flair/v1/room.pb.h"
#include "language_worker/handbook/choice.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/brief_facts.h"

namespace flair::language {

// A unit at its place: its back on a wall, its left end so far from the wall's start.
struct RunPlace {
  const v1::Object* object = nullptr;
  hb::RunPart part = hb::RUN_PART_UNSPECIFIED;
  int wall = 0;
  double offset_m = 0;
  double width_m = 0;
  // Of a basin: whether it is under a window.
  bool at_window = false;
  // So wide a piece over its middle hangs before no window.
  double clear_above_m = 0;

  double end_m() const { return offset_m + width_m; }
};

// Whether a run goes round the room in that way.
bool HasForm(const std::vector<RunPlace>& run, RunForm form);

// The best run of those objects that have a part in one, by walls and along each from its start, clear of doors and
// their leaves. Worktops whose ids are in `fitted` may take another width of their class. Empty when there is no basin
// or hob, more than one of either, no room for them, or a brief that tells the units' places in other words than a
// wall's.
std::vector<RunPlace> PlanRun(const v1::Room& room, const v1::ObjectList& objects, const BriefFacts& facts,
                              const Handbook& handbook, const Choice& choice, const std::set<std::string>& fitted = {});

}  // namespace flair::language
