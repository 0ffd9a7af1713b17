// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of a room, as pieces to add and sentences for a translator.
#pragma once

#include <map>
#include <string>

#include "session/layouts/lists.h"
#include "session/sentences/piece_wishes.h"

namespace flair::session {

// Sentences that a user has said in this room have ids that begin so.
inline constexpr char kSaid[] = "said_";

struct Said {
  // Pieces that are new.
  EditList adds;
  IdSet added_ids;
  // The sentences as people read them; and the same, by the same ids, for a translator, which calls new pieces by their
  // ids.
  v1::ConstraintList shown, meant;
  // By sentence, the user's own words for it where it is about nothing new.
  std::map<std::string, std::string> own_words;
  // Sentences that only say what a new piece is for: "an armchair to read in".
  IdSet purposes;
};

Said Written(const Wishes& wishes, const v1::SolvedLayout& layout);

// Why a sentence means nothing to a translator, for people; `examples`: what can be said instead.
std::string Refusal(const v1::Sentence& sentence, const v1::LayoutGraph& understood, const Catalogue& catalogue,
                    const std::string& examples);

}  // namespace flair::session
