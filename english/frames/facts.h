// SPDX-License-Identifier: GPL-3.0-or-later
// Facts as values: read from sentences that say nothing else, and as messages of the protocol.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "english/frames/frames.h"
#include "english/frames/term.h"
#include "flair/v1/meaning.pb.h"

namespace flair::english {

// A fact with what its frame bound.
struct Fact {
  std::string meaning;
  std::string detail;
  std::optional<Mention> a;
  std::optional<Mention> b;
  std::optional<Mention> c;
  std::optional<Length> distance;

  // Borrows the fact.
  Match AsMatch() const;
};

// The facts of a sentence, in order. Nothing unless they are all that it says, plainly and by name: without conditions,
// wishes and reasons, without pronouns and choices.
std::optional<std::vector<Fact>> ReadFacts(std::string_view text, const Names& names);

// A part of the room as a message, without a side; nothing for references to anything else, or to a wall by its name.
std::optional<::flair::v1::RoomPart> PartOf(const Reference& reference);
// The same the other way round.
Reference ReferenceTo(::flair::v1::RoomPart part);

// A side word of the lexicon as a message; nothing for words that messages do not have ("two adjacent sides").
std::optional<::flair::v1::ParticipantSide> SideOf(std::string_view word);
// The same the other way round; empty for none.
std::string_view WordOf(::flair::v1::ParticipantSide side);

}  // namespace flair::english
