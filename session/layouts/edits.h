// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of edits, before an optimizer is asked, and what they do to what was placed by hand.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "session/layouts/lists.h"

namespace flair::session {

// Added objects with an id, a role and a zone where the caller has left them out. An edit with an empty object_id that
// follows is about the object added last, and so is an empty argument of its own edges.
EditList Completed(const v1::SolvedLayout& layout, const EditList& edits);

// Edits that change nothing, but let a solve try again for what does not hold: the wishes, and pieces that are in the
// way.
EditList WhatStandsBadly(const v1::SolvedLayout& layout);

// In the graph's order: objects that are new in `after` or stand elsewhere than in `before`.
ObjectIds MovedIds(const v1::SolvedLayout& before, const v1::SolvedLayout& after);

// Whether nothing is left.
bool RemovesAll(const v1::SolvedLayout& layout, const EditList& edits);

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

}  // namespace flair::session
