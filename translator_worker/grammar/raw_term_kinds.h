// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include "translator_worker/grammar/mention.h"
#include "translator_worker/grammar/noun_phrases.h"

namespace flair::translator {

inline void BecomeWord(std::string lemma, RawTerm& raw) {
  raw.term.kind = Term::Kind::kWord;
  raw.term.lemma = std::move(lemma);
}

inline void BecomeReference(RefKind kind, std::string name, RawTerm& raw) {
  Reference reference;
  reference.kind = kind;
  reference.name = std::move(name);
  raw.term.kind = Term::Kind::kMention;
  raw.term.mention.references = {std::move(reference)};
}

}  // namespace flair::translator
