// SPDX-License-Identifier: GPL-3.0-or-later
// What pieces and acts are called for people, and which pieces a person means who names some.
#pragma once

#include <string>
#include <string_view>

#include "flair/v1/studio_service.pb.h"
#include "flair/v1/style_sheet.pb.h"
#include "session/layouts/lists.h"

namespace flair::session {

// "a desk", "an armchair".
std::string WithArticle(const std::string& name);
// Of an object; its id when it is none.
std::string NameOf(const v1::SolvedLayout& layout, const std::string& id);

// What acts are called, in the history and on buttons: "move the desk". `layout` is the one before the act, which names
// the objects.
std::string MoveLabel(const v1::SolvedLayout& layout, const v1::MoveObjects& move);
std::string EditLabel(const v1::SolvedLayout& layout, const EditList& edits);
std::string SayLabel(const std::string& text);
std::string WeighLabel(const v1::SolvedLayout& layout, const v1::WeighSentence& weigh);
// What an act on a sentence has done to pieces, behind its own label: "; added: desk; moved: bed, chair".
std::string AlsoMoved(const v1::SolvedLayout& before, const v1::SolvedLayout& after, const ObjectIds& moved_ids);

// Where `word` stands in `text` as a word of its own, from `from` on: "desk" is in "no desk", not in "desktop".
size_t FindWord(std::string_view text, std::string_view word, size_t from = 0);

// The objects that a sentence may mean: what has no place is not meant where something of its name has one, and of
// those that are like a selected one only what is selected, where `text` speaks of one of them.
v1::ObjectList MeantBy(const std::string& text, const v1::SolvedLayout& layout, const IdSet& selected);

// The looks of these objects, and of all that is no object of the layout.
v1::StyleSheet LooksOf(const v1::ObjectList& objects, const v1::SolvedLayout& layout);

// Gives an object the looks that another one has.
void LookLike(const std::string& like_id, const std::string& id, v1::LayoutGraph& graph);

// A message with names as the plan shows them ("dining chair 2") in the place of ids.
std::string WithNames(const std::string& message, const v1::SolvedLayout& layout);

}  // namespace flair::session
