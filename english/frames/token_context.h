// SPDX-License-Identifier: GPL-3.0-or-later
// What the words around a word say about it, and what conditions and brackets do to a sentence.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "english/frames/noun_phrases.h"
#include "english/lexicon.h"
#include "english/text.h"

namespace flair::english {

// A place in a sentence that is read from left to right: what has been made of it so far, and what follows.
struct TokenContext {
  const std::vector<Token>& tokens;
  size_t at = 0;
  const Names& names;
  const std::vector<RawTerm>& terms;
};

// "The lamp", "must", "not", or the beginning: a verb comes next, where "the" would bring a noun.
bool VerbFollows(const TokenContext& context);

// Whether a thing of the room, a door, a window or a socket is named at tokens[at].
bool NounFollows(const TokenContext& context, size_t at);

// The phrase of the lexicon. "Any side tables" is not "any side" and "tables", "any wall sockets" not "any wall": a
// name that begins within a phrase and ends after it cuts it short.
Phrase FindPhrase(const TokenContext& context);

// After "a", "one of the".
bool AnyIsMeant(const TokenContext& context);

// "Keep the front clear", "front accessibility": elsewhere "clear" tells only what kind of space.
bool EndsSideClear(const TokenContext& context, const Phrase& phrase);

// "Easily accessible from the front": from a side of its own, not from another thing.
bool ReachedFromSide(const TokenContext& context, const Phrase& phrase);

// Words of relations that relate nothing: "around 0.9 m", "between adjacent chairs", "the central plunge pool".
bool TellsWhichOne(const TokenContext& context, const Phrase& phrase);

// "Prosecution and defence tables" at the first word: the object that the last word of the list makes a name of; none
// when there is no such object. Of length 1.
Names::Found FindNameWithSharedHead(const TokenContext& context);

// Leaves out what the condition of `length` tokens at tokens[at] ("if") holds for, and the condition: an aside that
// follows what holds anyhow, or one clause of several, whose terms are taken off `terms`. Where reading goes on;
// nothing when the whole sentence is conditional.
std::optional<size_t> LeaveOutCondition(const std::vector<Token>& tokens, size_t at, size_t length,
                                        std::vector<RawTerm>& terms);

// What becomes of an opening bracket.
struct Bracket {
  enum class Kind {
    kPlain,    // its words are read like the rest, the bracket itself as a break
    kSkipped,  // it says nothing more; `next` is behind it
    kOpened,   // its words belong to what stands before; `next` is the first of them, `closing` the mark to leave out
  };
  Kind kind = Kind::kPlain;
  size_t next = 0;
  size_t closing = 0;
};

// Reads the bracket at tokens[at], if there is one. "(e.g., to place items)" explains; it says nothing of its own,
// unless it names the side that a word left open ("one side (typically the front)"), the members of a zone or class
// ("the seating area (sofa and armchair)") or how wide a space is ("(preferably 0.5 m)"), which go into `terms`.
Bracket ReadBracket(const std::vector<Token>& tokens, size_t at, const Names& names, std::vector<RawTerm>& terms);

// Makes some ways of saying a thing one, before phrases are looked up: adverbs that place nothing are dropped, "neither
// X nor Y" becomes "neither X and Y", "one accessible side" becomes "one side accessible", "there is room to sit" is
// space. Linear in the tokens.
std::vector<Token> PrepareTokens(std::vector<Token> tokens);

// Whether tokens[at] is the "to" of a reason: "0.9 m from the table to allow chairs to pull out" is not "from the table
// to the chairs".
bool BeginsReason(const std::vector<Token>& tokens, size_t at);

}  // namespace flair::english
