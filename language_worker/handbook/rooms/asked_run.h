// SPDX-License-Identifier: GPL-3.0-or-later
// What a brief says of the run along the walls, for the search in wall_run.cc.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "flair/v1/room.pb.h"
#include "language_worker/handbook/reading/brief_facts.h"

namespace flair::language {

struct AskedRun {
  std::optional<int> wall;  // of all but those that have one of their own
  std::map<std::string, int> wall_of;
  bool basin_at_window = false;
  bool others_at_window = false;  // a table has the place before it
  // Units that are to be near a door, or away from it; all of them without a name.
  struct AtDoor {
    std::string unit;
    v1::Point2 door;
    bool away;
  };
  std::vector<AtDoor> at_doors;
};

// Nothing when the brief tells the place of a unit in a way that decides the run otherwise.
std::optional<AskedRun> ReadAskedRun(const BriefFacts& facts, const v1::Room& room);

}  // namespace flair::language
