// SPDX-License-Identifier: GPL-3.0-or-later
// Which objects a person means who names some, and what they are called for people.
#pragma once

#include <string>

#include "flair/v1/object_list.pb.h"
#include "flair/v1/solved_layout.pb.h"
#include "flair/v1/style_sheet.pb.h"
#include "session/trying.h"

namespace flair::session {

// The objects that a sentence may mean: what has no place is not meant where something of its name has one, and of
// those that are like a selected one only what is selected, where `text` speaks of one of them.
v1::ObjectList MeantBy(const std::string& text, const v1::SolvedLayout& layout, const IdSet& selected);

// The looks of these objects, and of all that is no object of the layout.
v1::StyleSheet LooksOf(const v1::ObjectList& objects, const v1::SolvedLayout& layout);

// A message with names as the plan shows them ("dining chair 2") in the place of ids.
std::string WithNames(const std::string& message, const v1::SolvedLayout& layout);

}  // namespace flair::session
