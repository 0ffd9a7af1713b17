// SPDX-License-Identifier: GPL-3.0-or-later
// What solves leave where somebody has put it.
#pragma once

#include <map>
#include <string>

#include "session/layout_acts.h"

namespace flair::session {

// Who makes layouts that nothing has solved.
v1::Producer ByHand();

// Those that were placed by hand before, with those that the edits move; without those that they free or take away.
ObjectIds ByHandAfter(ObjectIds before, const EditList& edits);

// The edits, after which `held` stand pinned where they are shown; those of `by_hand` that are not held may move from
// there. `from`: the layout that the edits change.
absl::StatusOr<EditList> WithHolds(const v1::SolvedLayout& from, const v1::SolvedLayout& shown, const EditList& edits,
                                   const ObjectIds& by_hand, const ObjectIds& held);

// A solve holds what was moved; afterwards only what somebody has locked stays locked.
void KeepOnlyWantedPins(const v1::LayoutGraph& before, const EditList& edits, v1::LayoutGraph& graph);

// Of those that are held and stand in the same place as something else, or outside: of each pair the one that was put
// there first. With what is the matter.
std::map<std::string, std::string> WhatCannotBeHeld(const v1::SolvedLayout& layout, const ObjectIds& held);

// Tells that a piece had to move although it was placed by hand, and forgets that it was; nothing when it has not
// moved.
void TellFreed(const v1::SolvedLayout& before, const std::string& id, const std::string& reason, Acted& acted);

}  // namespace flair::session
