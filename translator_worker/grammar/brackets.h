// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "english/text.h"
#include "translator_worker/grammar/noun_phrases.h"
#include "translator_worker/grammar/scene_names.h"

namespace flair::translator {

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
Bracket ReadBracket(const std::vector<Token>& tokens, size_t at, const SceneNames& names, std::vector<RawTerm>& terms);

}  // namespace flair::translator
