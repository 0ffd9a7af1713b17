// SPDX-License-Identifier: GPL-3.0-or-later
// Where pieces are put without a solve.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "session/layouts/lists.h"

namespace flair::session {

// By object; as long as the layout's list does not change.
using Placements = std::map<std::string, v1::Placement*>;
Placements PlacementsOf(v1::SolvedLayout& layout);

// Puts objects where `placements` says. What follows them goes along (following.h), unless it is named itself.
// INVALID_ARGUMENT names the field, `path` first.
absl::Status Place(v1::SolvedLayout& layout, const google::protobuf::RepeatedPtrField<v1::Placement>& placements,
                   std::string_view path);

// Turns what is new at a wall so that its back is there, and hangs wall pieces on theirs. `put_there`: somebody has
// chosen the place, and what is not at a wall there is left alone.
void FaceIntoRoom(const v1::Room& room, const v1::Object& object, bool put_there, v1::Placement& at);

// Added pieces that are put by an edit onto what they are copies of, a piece of their name and size, are put beside it
// instead: all of them by the same way to the nearest free floor where there is such a way, else each by its own. What
// finds none stays.
void PutCopiesBeside(const v1::SolvedLayout& layout, EditList& edits);

// Moves what is to stand somewhere to the nearest free floor, each by itself and by `farthest_m` at most; whether there
// is such a place for all of them.
bool PutWhereFree(const v1::SolvedLayout& layout, double farthest_m,
                  google::protobuf::RepeatedPtrField<v1::Placement>& placements);

}  // namespace flair::session
