// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/named_sets.h"

#include <algorithm>

#include "english/words.h"
#include "language_worker/handbook/reading/other_words.h"
#include "language_worker/handbook/reading/vocabulary.h"

namespace flair::language {
namespace {

constexpr int kMostSets = 12;

class SetReader : Reading {
 public:
  explicit SetReader(const Reading& reading) : Reading(reading) {}

  void Read() {
    for (std::size_t i = 1; i < text.size(); ++i) {
      if (text.Says(i, {"each", "every"})) Take(i);
    }
  }

 private:
  // The list that begins behind "each": behind "with", "has", "one of them with", or at once in brackets.
  std::size_t ListBehind(std::size_t each) const {
    constexpr std::size_t kMostWords = 4;
    for (std::size_t at = each + 1; at <= each + kMostWords && !text.IsSign(at); ++at) {
      if (text.Is(at, "getting")) return at + 1;
      const bool bare = text.Says(at - 1, {"each", "them", "one"}) || text.Is(at - 1, "verbs_of_being");
      if (bare && text.Says(at, {"a", "an"})) return at;
    }
    return 0;
  }

  // "..., and one large table", "..., with a bench in the middle" is beside them.
  std::size_t EndOfList(std::size_t begin) const {
    std::size_t end = begin;
    for (; end < text.size() && !text.EndsSentence(end) && !text.Says(end, {")", "plus", "while"}); ++end) {
      const std::size_t next = text.Says(end, {",", "and"}) ? end + (text.At(end + 1) == "and" ? 2 : 1) : 0;
      if (next > 0 && (text.Says(next, {"with", "one", "the", "there"}) || text.Is(next, "place_prepositions"))) break;
    }
    return end;
  }

  int NumberAt(std::size_t i) const {
    if (text.Is(i, "articles") || text.Is(i + 1, "unit_words") || text.Is(i + 1, "piece_measures")) return 0;
    return text.IsNumber(i) ? static_cast<int>(std::clamp(text.NumberAt(i), 0.0, 100.0))
                            : NumberWord(text.At(i)).value_or(0);
  }

  void Take(std::size_t each) {
    constexpr std::size_t kMostBack = 9;
    const std::size_t begin = ListBehind(each), end = begin > 0 ? EndOfList(begin) : 0;
    const bool listed = std::any_of(text.tokens().begin() + static_cast<std::ptrdiff_t>(begin),
                                    text.tokens().begin() + static_cast<std::ptrdiff_t>(std::max(begin, end)),
                                    [](const Token& token) { return token.text == "," || token.text == "and"; });
    if (!listed) return;
    for (std::size_t at = each; at > 0 && at + kMostBack > each; --at) {
      const int count = NumberAt(at - 1);
      if (count < 2) continue;
      std::size_t noun = at;
      while (noun < each && !(text.IsWord(noun) && english::IsPlural(text.At(noun)))) ++noun;
      const bool of_the_room = IsFormIn("openings", text.At(noun)) || IsFormIn("wall_nouns", text.At(noun));
      if (noun == each || count > kMostSets || of_the_room) return;
      // What is said of pieces in one breath may go on with others: "desks, each with a chair, and a board".
      const bool piece = IsAPiece(at, noun + 1), people = CountsPeople(text.At(noun));
      const bool opens = text.EndsSentence(each - 1) || text.Says(each - 1, {"(", ":"});
      if (piece && !opens && !IsFormIn("stations", text.At(noun))) return;
      NamedSet set{count, people ? "" : english::Singular(text.At(noun)), begin, end, noun};
      if (!piece && !people) Tell(at - 1, noun + 1);
      if (!piece && !people) Use(at - 1, noun + 1);
      facts.sets.push_back(set);
      return;
    }
  }

  bool IsAPiece(std::size_t begin, std::size_t end) const {
    for (std::size_t i = begin; i < end; ++i) {
      if (LongestAt(handbook.vocabulary().names, tokens(), i, /*plural=*/true).second + i >= end) return true;
    }
    return false;
  }
};

}  // namespace

void ReadSets(const Reading& reading) { SetReader(reading).Read(); }

NamedSet* SetAt(std::size_t i, BriefFacts& facts) {
  const auto set = std::ranges::find_if(facts.sets, [&](const NamedSet& one) { return one.begin <= i && i < one.end; });
  return set == facts.sets.end() ? nullptr : &*set;
}

}  // namespace flair::language
