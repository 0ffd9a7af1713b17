// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/documents/furniture_search.h"

#include <algorithm>
#include <ranges>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_split.h"
#include "english/words.h"

namespace flair::session {
namespace {

using Words = std::vector<std::string>;

// Names, and other words for them, that are just what was typed.
constexpr int kSameName = 100, kSameWord = 50;
// Kinds of what was typed by another word for them ("oil painting"), what is like the best, and the rest.
constexpr int kOfThatKind = 3, kAlike = 2, kNear = 1;
// A whole word of the name, or the beginning of one; less is no reason to show what is like it.
constexpr int kStrong = 3;
// Other words are many: fewer letters begin too many of them.
constexpr size_t kFewestLetters = 3;

int RankOfWord(const std::string& word, const std::string& name, const v1::FurnitureOffer& offer) {
  if (name == word) return 8;
  if (absl::StartsWith(name, word)) return 4;
  if (absl::StrContains(name, " " + word)) return kStrong;
  const bool is_near = absl::StrContains(name, word) || absl::StrContains(offer.group(), word) ||
                       absl::StrContains(offer.object().description(), word);
  return is_near ? 1 : 0;
}

// How well a piece answers by its name: words at the beginning of it first; 0 not at all.
int RankOf(const v1::FurnitureOffer& offer, const Words& words) {
  const std::string name = absl::AsciiStrToLower(offer.object().name());
  int rank = 1;
  for (const std::string& word : words) {
    const int best = std::max(RankOfWord(word, name, offer), RankOfWord(english::Singular(word), name, offer));
    if (best == 0) return 0;
    rank += best;
  }
  return rank;
}

bool BeginsAWordOf(const std::string& text, const std::string& word) {
  return absl::StartsWith(text, word) || absl::StrContains(text, " " + word);
}

}  // namespace

std::vector<const v1::FurnitureOffer*> FoundFurniture(const DocumentParts& parts, const std::string& query) {
  const auto& offers = parts.furniture;
  const Words words = absl::StrSplit(absl::AsciiStrToLower(query), absl::ByAnyChar(" ,"), absl::SkipEmpty());
  const std::string phrase = absl::StrJoin(words, " "), one = english::Singular(phrase);
  std::vector<int> ranks(offers.size());
  for (size_t i = 0; i < offers.size(); ++i) {
    const std::string name = absl::AsciiStrToLower(offers[i].object().name());
    ranks[i] = name == phrase || name == one ? kSameName : RankOf(offers[i], words);
  }
  if (phrase.size() >= kFewestLetters) {
    for (const auto& [word, meant] : parts.furniture_words) {
      const bool is_same = word == phrase || word == one;
      const bool is_kind = absl::EndsWith(word, " " + phrase) || absl::EndsWith(word, " " + one);
      const bool is_near = std::ranges::all_of(words, [&](const std::string& typed) {
        return BeginsAWordOf(word, typed) || BeginsAWordOf(word, english::Singular(typed));
      });
      const int rank = is_same ? kSameWord : is_kind ? kOfThatKind : is_near ? kNear : 0;
      for (const int i : meant) ranks[i] = std::max(ranks[i], rank);
    }
  }
  const auto best = std::ranges::max_element(ranks);
  if (!words.empty() && best != ranks.end() && *best > kStrong) {
    const std::string& category = offers[best - ranks.begin()].object().category();
    for (size_t i = 0; i < offers.size(); ++i) {
      if (!category.empty() && offers[i].object().category() == category) ranks[i] = std::max(ranks[i], kAlike);
    }
  }
  std::vector<size_t> order;
  for (size_t i = 0; i < offers.size(); ++i) {
    if (ranks[i] > 0) order.push_back(i);
  }
  std::ranges::stable_sort(order, std::greater(), [&](size_t i) { return ranks[i]; });
  std::vector<const v1::FurnitureOffer*> found;
  for (const size_t i : order) found.push_back(&offers[i]);
  return found;
}

}  // namespace flair::session
