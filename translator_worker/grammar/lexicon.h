// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "translator_worker/grammar/token.h"

namespace flair::translator {

// What a word or phrase is to the grammar.
enum class WordClass {
  kRelation,   // "close to": lemma "near", what rules are written with
  kFiller,     // says nothing about places: "should be placed"
  kModal,      // like a filler, but shows that a clause begins: "should", "is"
  kWish,       // "ideally": halves the weight
  kPurpose,    // "so that", "because": what follows is a reason
  kCondition,  // "if": what holds only sometimes cannot be said
  kNot,        // "avoid", "no"
  kSide,       // lemma: a side word, see SideWord
  kFeature,    // lemma: "door", "window", "socket"
  kPlace,      // lemma: "wall", "ceiling", "room", "floor"
  kArea,       // "area", "zone": makes the words before it a zone
  kGroup,      // lemma: a class of objects: "all", "others", "seating"...
  kPronoun,    // lemma: "it", "them", "each other"
  kVague,      // lemma: topic that no layout call expresses: "paths", "lighting"...
  kQuantity,   // "each", "every", "all", "both"
  kOrdinal,    // lemma: "1", "2"...
  kAnd,
  kOr,
};

// A phrase found in a sentence.
struct Phrase {
  WordClass word_class = WordClass::kFiller;
  std::string lemma;
  // How many tokens it covers; 0 when nothing was found.
  size_t length = 0;
};

// Every word that the grammar knows, except the names of the room's own objects. Immutable and thread-safe.
class Lexicon {
 public:
  // The one lexicon, read from lexicon_entries.cc on first use.
  static const Lexicon& Get();

  // The longest phrase that begins at tokens[at].
  Phrase Find(const std::vector<Token>& tokens, size_t at, size_t max_length = 100) const;

  // Another form of a word that the lexicon has: "encroaches", "obstructive" has none. Only for words that it has not
  // itself. Of length 0 when there is none.
  Phrase FindForm(const Token& token) const;

 private:
  struct Entry {
    std::vector<std::string> words;
    WordClass word_class;
    std::string lemma;
  };
  explicit Lexicon(std::string_view entries);

  // By first word; longest first.
  std::map<std::string, std::vector<Entry>, std::less<>> by_first_word_;
  // Single words without their endings, those that say what is related to what.
  std::map<std::string, Entry, std::less<>> by_stem_;
};

// Writes out a phrase with options: "[flush] (against|on)" becomes "against", "flush against", "on", "flush on".
std::vector<std::vector<std::string>> ExpandPhrase(std::string_view phrase);

// The texts that the lexicon is read from, relations first; see lexicon_entries.cc for their form.
std::string_view LexiconRelations();
std::string_view LexiconEntries();

}  // namespace flair::translator
