// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "translator_worker/grammar/mention.h"
#include "translator_worker/grammar/scene_names.h"

namespace flair::translator {

// What is left of a sentence when filler is gone: what patterns are matched against.
struct Term {
  enum class Kind {
    kWord,      // lemma of a relation word; "not"; "or"
    kMention,   // a noun phrase
    kDistance,  // a length
    kSoft,      // comma, "and", "with": may stand within a fact
    kStop,      // end of a sentence
    kPurpose,   // "for", "to": a reason follows
    kUnknown,   // a word that the grammar does not know
  };
  Kind kind = Kind::kUnknown;
  std::string lemma;
  Mention mention;
  Distance distance;
  // Bytes of the sentence.
  size_t begin = 0;
  size_t end = 0;

  bool IsWord(std::string_view word) const { return kind == Kind::kWord && lemma == word; }
  bool IsAnyWord(std::initializer_list<std::string_view> words) const {
    return kind == Kind::kWord && std::find(words.begin(), words.end(), lemma) != words.end();
  }
};

// A sentence made ready for the rules.
struct Analysis {
  std::vector<Term> terms;
  // "Ideally", "preferably", "if possible".
  bool wish = false;
  // Holds only sometimes: "if the room is small".
  bool conditional = false;
  // A clause that holds only sometimes was left out.
  bool partly_conditional = false;
};

// Reads a sentence: tokens, lengths, words, names, noun phrases. Linear in the length of the text.
Analysis Analyse(std::string_view text, const SceneNames& names);

}  // namespace flair::translator
