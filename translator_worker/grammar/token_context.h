// SPDX-License-Identifier: GPL-3.0-or-later
// What the words around a word say about it: a verb or a noun, any one or this one, a side that is reached or a thing.
#pragma once

#include <cstddef>
#include <vector>

#include "english/lexicon.h"
#include "english/text.h"
#include "translator_worker/grammar/noun_phrases.h"
#include "translator_worker/grammar/scene_names.h"

namespace flair::translator {

// A place in a sentence that is read from left to right: what has been made of it so far, and what follows.
struct TokenContext {
  const std::vector<Token>& tokens;
  size_t at = 0;
  const SceneNames& names;
  const std::vector<RawTerm>& terms;
};

// "The lamp", "must", "not", or the beginning: a verb comes next, where "the" would bring a noun.
bool VerbFollows(const TokenContext& context);

// Whether a thing of the room, a door, a window or a socket is named at tokens[at].
bool NounFollows(const TokenContext& context, size_t at);

// Whether a side is named at tokens[at].
bool SideFollows(const TokenContext& context, size_t at);

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
SceneNames::Found FindNameWithSharedHead(const TokenContext& context);

}  // namespace flair::translator
