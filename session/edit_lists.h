// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of edits, before an optimizer is asked.
#pragma once

#include <string>
#include <vector>

#include "flair/v1/layout_edit.pb.h"
#include "flair/v1/solved_layout.pb.h"

namespace flair::session {

using EditList = google::protobuf::RepeatedPtrField<v1::LayoutEdit>;

// Added objects with an id, a role and a zone where the caller has left them out. An edit with an empty object_id that
// follows is about the object added last, and so is an empty argument of its own edges.
EditList Completed(const v1::SolvedLayout& layout, const EditList& edits);

// Edits that change nothing, but let a solve try again for what does not hold: the wishes, and pieces that are in the
// way.
EditList WhatStandsBadly(const v1::SolvedLayout& layout);

// In the graph's order: objects that are new in `after` or stand elsewhere than in `before`.
std::vector<std::string> MovedIds(const v1::SolvedLayout& before, const v1::SolvedLayout& after);

// Whether nothing is left.
bool RemovesAll(const v1::SolvedLayout& layout, const EditList& edits);

}  // namespace flair::session
