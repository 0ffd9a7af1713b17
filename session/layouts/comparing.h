// SPDX-License-Identifier: GPL-3.0-or-later
// How well a layout has come out, beside another one.
#pragma once

#include "session/layouts/lists.h"

namespace flair::session {

// `ids` with what sentences name together with them, what stands around them, and what stands on any of these.
IdSet InReach(const v1::SolvedLayout& layout, const IdSet& ids);

// Whether `a` is better than `b`, both made of `before`: fewer faults, then less weight of what does not hold, then
// less cost by more than moving is worth.
bool IsBetter(const v1::SolvedLayout& a, const v1::SolvedLayout& b, const v1::SolvedLayout& before);

// What nothing is better than, to compare by where nothing that is wrong already is taken as given.
v1::SolvedLayout Flawless();

// Whether `a` has fewer faults than `b`, or as many and less weight of what does not hold.
bool HoldsMore(const v1::SolvedLayout& a, const v1::SolvedLayout& b, const v1::SolvedLayout& before);

bool HasMoreFaults(const v1::SolvedLayout& layout, const v1::SolvedLayout& before);
// Whether there are more faults than before, or clearly less of the floor can be reached.
bool IsWorseOff(const v1::SolvedLayout& layout, const v1::SolvedLayout& before);

}  // namespace flair::session
