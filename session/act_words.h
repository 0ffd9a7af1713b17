// SPDX-License-Identifier: GPL-3.0-or-later
// What acts are called, in the history and on buttons: "move the desk".
#pragma once

#include <string>
#include <vector>

#include "flair/v1/solved_layout.pb.h"
#include "flair/v1/studio_service.pb.h"

namespace flair::session {

// "a desk", "an armchair".
std::string WithArticle(const std::string& name);

// Of an object; its id when it is none.
std::string NameOf(const v1::SolvedLayout& layout, const std::string& id);

// `layout` is the one before the act, which names the objects.
std::string MoveLabel(const v1::SolvedLayout& layout, const v1::MoveObjects& move);
std::string EditLabel(const v1::SolvedLayout& layout, const google::protobuf::RepeatedPtrField<v1::LayoutEdit>& edits);
std::string SayLabel(const std::string& text);
// What an act on a sentence has done to pieces, behind its own label: "; added: desk; moved: bed, chair".
std::string AlsoMoved(const v1::SolvedLayout& before, const v1::SolvedLayout& after,
                      const std::vector<std::string>& moved_ids);
std::string WeighLabel(const v1::SolvedLayout& layout, const v1::WeighSentence& weigh);

}  // namespace flair::session
