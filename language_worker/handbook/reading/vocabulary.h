// SPDX-License-Identifier: GPL-3.0-or-later
// The words that briefs may use for pieces, rooms and colours, and misspelt ones among them.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "english/lexicon.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/meanings.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// One way to say something, and what is then meant.
template <typename T>
struct Saying {
  Phrase phrase;
  const T* meaning;
};

// The longest saying that begins at a token; of equally long ones that which `rank` puts highest, then the first.
template <typename T, typename Rank>
std::pair<const T*, std::size_t> BestAt(const std::vector<Saying<T>>& sayings, const std::vector<Token>& tokens,
                                        std::size_t i, bool plural, const Rank& rank) {
  std::pair<const T*, std::size_t> best = {nullptr, 0};
  for (const Saying<T>& saying : sayings) {
    const std::size_t length = saying.phrase.MatchAt(tokens, i, plural);
    if (length == 0 || length < best.second) continue;
    if (length > best.second || rank(*saying.meaning) > rank(*best.first)) best = {saying.meaning, length};
  }
  return best;
}

template <typename T>
std::pair<const T*, std::size_t> LongestAt(const std::vector<Saying<T>>& sayings, const std::vector<Token>& tokens,
                                           std::size_t i, bool plural) {
  return BestAt(sayings, tokens, i, plural, [](const T&) { return 0; });
}

// The words that name classes: those of the handbook and, behind them, those that do so in one brief only.
struct PieceNames {
  const std::vector<Saying<hb::Furniture>>* all = nullptr;
  std::vector<Saying<hb::Furniture>> more = {};
};

template <typename Rank>
std::pair<const hb::Furniture*, std::size_t> BestAt(const PieceNames& names, const std::vector<Token>& tokens,
                                                    std::size_t i, bool plural, const Rank& rank) {
  const auto best = BestAt(*names.all, tokens, i, plural, rank), more = BestAt(names.more, tokens, i, plural, rank);
  const bool better = more.second > best.second ||
                      (more.second > 0 && more.second == best.second && rank(*more.first) > rank(*best.first));
  return better ? more : best;
}

inline std::pair<const hb::Furniture*, std::size_t> LongestAt(const PieceNames& names, const std::vector<Token>& tokens,
                                                              std::size_t i, bool plural) {
  return BestAt(names, tokens, i, plural, [](const hb::Furniture&) { return 0; });
}

template <typename T>
void AddOnce(std::vector<const T*>& list, const T* item) {
  if (std::find(list.begin(), list.end(), item) == list.end()) list.push_back(item);
}

// A word that was read as another one.
struct Correction {
  std::string written;
  std::string read;
};

// Whether a letter put in, left out, changed, or swapped with its neighbour makes one word the other. Equal words are
// not.
bool IsOneEditAway(std::string_view a, std::string_view b);

// Reads misspelt words of the handbook: "kichen" as kitchen, "wardorbe" as wardrobe. Only words of five letters or more
// that are no common English, and only where exactly one known word is one edit away.
class Speller {
 public:
  // Keeps nothing of `handbook`.
  explicit Speller(const hb::Handbook& handbook);

  // The word that is meant; empty when none or more than one is near, or the word is right as it is.
  std::string MeantBy(std::string_view word) const;

  // Whether it is a word of the handbook, or a common one, in any form.
  bool Knows(std::string_view word) const;

  // Replaces misspelt words. Linear in the number of tokens. Returns what it has replaced, each once.
  std::vector<Correction> Correct(std::vector<Token>& tokens) const;

 private:
  void Learn(std::string_view phrase, bool corrects);
  bool IsRight(const std::string& word) const { return right_.contains(word); }

  std::unordered_set<std::string> right_;  // never corrected
  // Words that others are corrected to, under their first and under their last two letters: one edit leaves one of
  // these.
  std::unordered_map<std::string, std::vector<std::string>> by_ends_;
};

// Words for a place, and what follows them: "door", "window", "wall", "corner", "target", "targets", or the "pieces"
// themselves; empty when nothing does.
struct PlaceWords {
  const hb::AskedPlace* asked = nullptr;
  std::string slot;
  bool denied = false;  // they stand behind "not", maybe apart: "must not be placed near the door"
  english::PhraseBook words;
};

// Made once for a handbook: the same in every kind of room.
struct Vocabulary {
  // A noun for several classes, with the words before it that tell which.
  struct Head {
    struct Modifier {
      Phrase words;
      const hb::Furniture* furniture;
    };
    const hb::Noun* noun;
    std::vector<Phrase> words;
    std::vector<const hb::Furniture*> options;
    std::vector<Modifier> modifiers;
  };

  // `handbook` must outlive it and have its look-up tables.
  explicit Vocabulary(const Handbook& handbook);
  // With the words of further classes, which come first and must outlive it.
  Vocabulary(const Vocabulary& base, const std::vector<hb::Furniture>& own);

  // A class by its last word alone, "bath" for a dog bath, where that means another class elsewhere.
  struct ShortName {
    Phrase word;
    const hb::Furniture* furniture;
    const hb::Furniture* elsewhere;
  };

  std::vector<Saying<hb::Furniture>> names;  // every word that names a class, words for several of them first
  std::vector<Saying<hb::Archetype>> rooms;  // but for the fallback
  std::vector<Saying<hb::NamedColour>> colours;
  std::vector<Head> heads;
  std::vector<ShortName> short_names;
  std::vector<Phrase> other_things;
  std::shared_ptr<const std::vector<PlaceWords>> places;
  std::shared_ptr<const Speller> speller;
  std::shared_ptr<const Meanings> meanings;
};

}  // namespace flair::language
