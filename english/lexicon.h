// SPDX-License-Identifier: GPL-3.0-or-later
// Phrases and what they are: the longest one that begins at a word.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "english/language.h"
#include "english/text.h"

namespace flair::english {

// Phrases with options, "[right] (next|close) to", kept as they are written and found by their first word: nothing is
// expanded. Values are the caller's own. Immutable once filled.
class PhraseBook {
 public:
  // `phrase`: words separated by spaces; [x] may be left out, (x|y) is either. Brackets must match.
  void Add(std::string_view phrase, int value);

  struct Match {
    int value = -1;
    size_t length = 0;  // tokens covered; 0 when nothing was found
  };

  // The longest phrase of at most `max_length` tokens that begins at tokens[at]; of equals the one added first.
  // `last_form`: the last word may stand in another form of its noun.
  Match Find(const std::vector<Token>& tokens, size_t at, size_t max_length = kAnyLength, bool last_form = false) const;

  static constexpr size_t kAnyLength = 1000;

  // Single words that are phrases by themselves, with their values.
  std::vector<std::pair<std::string, int>> SingleWords() const;

 private:
  // A word, or a choice of sequences when `word` is empty.
  struct Element {
    std::string word;
    std::vector<std::vector<Element>> choices;
    bool optional = false;
  };
  using Sequence = std::vector<Element>;
  // The part of a sequence that is still to come, then what comes after the bracket that it stands in.
  struct Rest {
    const Sequence* sequence;
    size_t next;
    const Rest* outer;
  };
  struct Search;

  static Sequence Parse(std::string_view text, size_t& at);
  static void FirstWords(const Rest& rest, std::vector<std::string>& words);
  static void Step(const Search& search, size_t at, const Rest& rest, size_t& longest);

  struct Entry {
    Sequence sequence;
    int value;
  };
  std::vector<Entry> entries_;
  std::unordered_map<std::string, std::vector<size_t>> by_first_word_;
  // Other forms of the first words of phrases of one word.
  std::unordered_map<std::string, std::vector<size_t>> by_singular_;
};

// A phrase found in a sentence.
struct Phrase {
  v1::WordClass word_class = v1::WORD_CLASS_FILLER;
  std::string lemma;
  size_t length = 0;  // tokens covered; 0 when nothing was found
};

// The phrases of a language's data. Immutable and thread-safe.
class Lexicon {
 public:
  // That of Language::Get().
  static const Lexicon& Get();

  explicit Lexicon(const v1::Language& data);

  // The longest phrase that begins at tokens[at].
  Phrase Find(const std::vector<Token>& tokens, size_t at, size_t max_length = PhraseBook::kAnyLength) const;

  // Another form of a relation's single word: "encroaches". Only for words that it has not itself.
  Phrase FindForm(const Token& token) const;

 private:
  PhraseBook phrases_;
  std::vector<std::pair<v1::WordClass, std::string>> meanings_;
  std::map<std::string, int, std::less<>> by_stem_;
};

}  // namespace flair::english
