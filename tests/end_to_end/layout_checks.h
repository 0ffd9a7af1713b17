// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold in every furnished room, read from its layout artifact alone.
#pragma once

#include <string>
#include <vector>

#include "flair/v1/solved_layout.pb.h"

namespace flair::testing {

// One sentence per fault; empty when the room is good: sizes plausible, everything placed, nothing outside, nothing in
// something else or in a door's swing, the door's landing free, every bed's head on a wall, every chair of a table or
// desk turned towards one.
std::vector<std::string> FindFaults(const v1::SolvedLayout& layout);

}  // namespace flair::testing
