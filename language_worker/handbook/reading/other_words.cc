// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/other_words.h"

#include <algorithm>
#include <cmath>

#include "absl/strings/numbers.h"
#include "english/wordnet.h"
#include "language_worker/handbook/reading/meanings.h"

namespace flair::language {
namespace {

constexpr std::size_t kMostAdverbs = 4;
constexpr std::size_t kMostBeforePersons = 2;
constexpr double kMostCounted = 2000;
constexpr std::size_t kMostThings = 8;
constexpr std::size_t kShortText = 4;
constexpr std::size_t kShortestName = 4;

class PeopleReader {
 public:
  PeopleReader(const std::vector<Token>& tokens, std::vector<bool>& used)
      : text_(tokens), tokens_(tokens), used_(used) {}

  std::optional<int> Read() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (used_[i]) continue;
      const bool purpose = text_.At(i) == "for";
      if (purpose || text_.Is(i, "holds_people")) {
        if (const std::optional<int> number = Introduced(i + 1)) return number;
      }
      if (const std::optional<int> number = NumberOfPersons(i)) return number;
    }
    // Nobody counts twins, or oneself and one's wife.
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      const std::optional<std::size_t> end = used_[i] ? std::nullopt : text_.BehindPhrase(i, "two_people");
      if (end) return Take(i, *end, WithOthers(*end, 2).value_or(2));
    }
    return std::nullopt;
  }

 private:
  bool Ends(std::size_t i) const {
    return i >= text_.size() || (text_.IsSign(i) && !text_.Says(i, {"-", "'", "\""})) || text_.Is(i, "people_ends");
  }

  std::optional<int> NumberAt(std::size_t i) const {
    if (i >= tokens_.size() || used_[i]) return std::nullopt;
    const Token& token = tokens_[i];
    if (token.kind == Token::Kind::kNumber) {
      const bool whole = token.number >= 1 && token.number <= kMostCounted && token.number == std::floor(token.number);
      return whole ? std::optional<int>(static_cast<int>(token.number)) : std::nullopt;
    }
    return IsIn("vague_numbers", token.text) ? std::nullopt : NumberWord(token.text);
  }

  // Behind "for", "seats", "a family of": a number that ends its phrase or counts whom it is for.
  std::optional<int> Introduced(std::size_t at) {
    const std::size_t start = at;
    while (at < start + kMostAdverbs && (text_.Is(at, "about_numbers") || text_.Is(at, "before_people"))) ++at;
    const std::optional<int> number = NumberAt(at);
    if (!number) return std::nullopt;
    if (Ends(at + 1)) return Take(start - 1, at + 1, *number);
    for (std::size_t noun = at + 1; noun <= at + 1 + kMostBeforePersons && noun < tokens_.size(); ++noun) {
      if (text_.IsHyphen(noun)) continue;
      if (!text_.IsWord(noun) || used_[noun] || Ends(noun)) break;
      if (CountsPeople(text_.At(noun))) {
        const std::optional<int> all = WithOthers(noun + 1, *number);
        return Take(start - 1, noun + 1, all.value_or(*number));
      }
    }
    return std::nullopt;
  }

  // "twenty students", "a couple and their three children", "forty seats".
  std::optional<int> NumberOfPersons(std::size_t i) {
    const std::optional<int> number = NumberAt(i);
    if (!number) return std::nullopt;
    // "Where twelve can eat."
    if (*number > 1 && text_.Is(i + 1, "modal_verbs") && text_.IsWord(i + 2)) return Take(i, i + 2, *number);
    if (const auto us = text_.BehindPhrase(i + 1, "of_us"); us && *number > 1) return Take(i, *us, *number);
    for (std::size_t noun = i + 1; noun <= i + 1 + kMostBeforePersons && noun < tokens_.size(); ++noun) {
      if (text_.IsHyphen(noun)) continue;
      if (!text_.IsWord(noun) || used_[noun] || Ends(noun)) break;
      if (!CountsPeople(text_.At(noun))) continue;
      if (*number < 2) return std::nullopt;
      return Take(i, noun + 1, WithOthers(noun + 1, *number).value_or(*number));
    }
    return std::nullopt;
  }

  // "... and three children": they come on top.
  std::optional<int> WithOthers(std::size_t at, int number) const {
    if (!text_.Says(at, {"and", "with"})) return std::nullopt;
    ++at;
    while (text_.Says(at, {"their", "her", "his"})) ++at;
    std::optional<int> more = NumberAt(at);
    if (!more && text_.Says(at, {"a", "an"})) more = 1;
    if (!more || !CountsPeople(text_.At(at + 1)) || text_.At(at + 1) == "seats") return std::nullopt;
    return number + *more;
  }

  int Take(std::size_t begin, std::size_t end, int number) {
    Mark(begin, end, used_);
    return number;
  }

  const BriefText text_;
  const std::vector<Token>& tokens_;
  std::vector<bool>& used_;
};

// Whether it asks for nothing by itself, in whatever form.
bool IsIdle(std::string_view word) {
  return std::ranges::any_of(WordsOf("idle_lists"), [&](const std::string& list) { return IsFormIn(list, word); });
}

// "Aged 9", "he's 15", "our son (4)".
bool IsAge(const BriefText& text, std::size_t i) {
  if (text.BehindPhrase(text.IsHyphen(i + 1) ? i + 2 : i + 1, "years_of_age")) return true;
  std::size_t before = i - std::min<std::size_t>(i, 1);
  if (text.Says(before, {"is", "am", "'s", "'m", "are", "(", ","}) && before > 0) --before;
  return text.Is(before, "ages") || (before + 1 < i && (text.Is(before, "pronouns") || CountsPeople(text.At(before))));
}

// Where the clause that begins at a token ends.
std::size_t ClauseEnd(const BriefText& text, std::size_t begin) {
  std::size_t end = begin;
  while (end < text.size() && !(text.IsSign(end) && text.Is(end, "clause_signs")) &&
         !(end > begin && text.Is(end, "clause_links"))) {
    ++end;
  }
  return end;
}

}  // namespace

bool CountsPeople(std::string_view word) { return IsFormIn("persons", word) || MeansPeople(word); }

std::optional<int> ReadPeople(const std::vector<Token>& tokens, std::vector<bool>& used) {
  return PeopleReader(tokens, used).Read();
}

PeopleInGroups ReadPeopleInGroups(const std::vector<Token>& tokens, std::vector<bool>& used) {
  constexpr int kFewest = 2, kMost = 12;
  const BriefText text(tokens);
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (used[i] || used[i + 1] || !text.Says(i, {"in", "at", "into"})) continue;
    // "In six groups of four".
    const std::size_t what = i + (NumberWord(text.At(i + 1)) || text.IsNumber(i + 1) ? 2 : 1), at = what + 2;
    const bool pairs = text.At(what) == "pairs", of = text.At(what + 1) == "of";
    const bool group = IsFormIn("groups_of_pieces", text.At(what)) || text.At(what) == "tables";
    const int number = text.IsNumber(at) ? static_cast<int>(text.NumberAt(at)) : NumberWord(text.At(at)).value_or(0);
    if (!pairs && !(group && of && number >= kFewest && number <= kMost)) continue;
    Mark(i, pairs ? what + 1 : at + 1, used);
    return {pairs ? 2 : number, pairs || IsFormIn("rows_of_pieces", text.At(what))};
  }
  return {};
}

std::optional<int> ReadYear(const std::vector<Token>& tokens, std::vector<bool>& used) {
  constexpr double kLeast = 1000, kToday = 1990, kMostCentury = 19;
  const BriefText text(tokens);
  const auto take = [&](std::size_t begin, std::size_t end, double year) {
    Mark(begin, end, used);
    return static_cast<int>(year);
  };
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    // "1950s" may be one word.
    int decade_word = 0;
    const std::string_view word = text.At(i);
    const bool digits =
        word.size() == 5 && word.back() == 's' && absl::SimpleAtoi(std::string(word.substr(0, 4)), &decade_word);
    if (digits && !used[i] && decade_word >= kLeast && decade_word < kToday) return take(i, i + 1, decade_word);
    if (!text.IsNumber(i) || used[i]) continue;
    const double number = text.NumberAt(i);
    std::size_t next = i + 1;
    if (text.Is(next, "ordinal_endings")) ++next;
    if (text.IsHyphen(next)) ++next;
    const bool century = number >= 1 && number <= kMostCentury && text.Says(next, {"century", "c"}) && next > i + 1;
    if (century) return take(i, next + 1, 100 * number - 50);
    const bool decade = text.Says(i + 1, {"s"});
    const bool dated = i > 0 && text.Is(i - 1, "before_years") && !text.Is(i + 1, "unit_words");
    if (number >= kLeast && number < kToday && number == std::floor(number) && (decade || dated)) {
      return take(i - (dated ? 1 : 0), i + (decade ? 2 : 1), number);
    }
  }
  return std::nullopt;
}

bool ReadsAsEnglish(const std::vector<Token>& tokens) {
  std::size_t words = 0;
  for (const Token& token : tokens) {
    if (token.kind != Token::Kind::kWord) continue;
    if (IsIn("english", token.text)) return true;
    words += token.text.size() > 1 ? 1 : 0;
  }
  return words <= kShortText;
}

bool IsForeign(const std::vector<Token>& tokens) {
  const auto has = [&](std::string_view list) {
    return std::ranges::any_of(
        tokens, [&](const Token& token) { return token.kind == Token::Kind::kWord && IsIn(list, token.text); });
  };
  return has("foreign") && !has("small_words");
}

std::vector<std::string> UnheardClauses(const std::vector<Token>& tokens, const std::vector<bool>& used,
                                        const Vocabulary& vocabulary) {
  constexpr std::size_t kFewest = 3, kFewestSaying = 2;  // fewer make no sense without the others of their clause
  const BriefText text(tokens);
  const auto says_something = [&](std::size_t i) {
    return text.IsWord(i) && text.At(i).size() >= kShortestName && !IsIdle(text.At(i)) &&
           !vocabulary.speller->Knows(text.At(i));
  };
  const auto is_thing = [&](std::size_t i) {
    return !english::WordNet::Get().Knows(text.At(i)) || vocabulary.meanings->ThingOf(text.At(i)).is_thing;
  };
  const auto asks = [&](std::size_t i) {
    // "An L-shaped sofa".
    const std::size_t shaped = text.At(i) == "shaped" ? i : text.IsHyphen(i + 1) ? i + 2 : i + 1;
    if (text.At(shaped) == "shaped" && shaped + 1 < used.size() && used[shaped + 1]) return false;
    if (text.IsNumber(i)) return !IsAge(text, i);
    if (text.Is(i, "asking_words") || IsFormIn("thing_nouns", text.At(i))) return true;
    if (LongestAt(vocabulary.rooms, tokens, i, true).second > 0) return false;  // where the room is, or whose
    return text.IsWord(i) &&
           (LongestAt(vocabulary.names, tokens, i, true).second > 0 ||
            LongestAt(vocabulary.colours, tokens, i, false).second > 0 || (says_something(i) && is_thing(i)));
  };
  std::vector<std::string> all;
  const auto tell = [&](std::size_t begin, std::size_t end) {
    const bool link = text.Is(begin, "clause_links") && !text.Is(begin, "clause_openers");
    if (begin += link ? 1 : 0; begin + 1 < end) all.push_back(text.Quote(begin, end));
  };
  for (std::size_t begin = 0, end = 0; begin < tokens.size() && all.size() < kMostThings; begin = end) {
    end = std::max(ClauseEnd(text, begin), begin + 1);
    const auto first = used.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = used.begin() + static_cast<std::ptrdiff_t>(end);
    if (std::find(first, last, true) == last) {
      bool said = false;
      for (std::size_t i = begin; i < end; ++i) said = said || asks(i) || says_something(i);
      if (said) tell(begin, end);
      continue;
    }
    // What is left of a clause that was heard in part.
    for (std::size_t i = begin, stop = begin; i < end; i = stop + 1) {
      bool asked = false, plainly = false, denied = false, place = false;
      std::size_t saying = 0;
      for (stop = i; stop < end && !used[stop]; ++stop) {
        asked = asked || asks(stop);
        plainly = plainly ||
                  (asks(stop) && (text.IsNumber(stop) || LongestAt(vocabulary.names, tokens, stop, true).second > 0));
        denied = denied || text.Says(stop, {"not", "nothing", "never", "nobody"});
        place = place || (text.Is(stop, "place_words") && stop + 1 < end);
        saying += !asks(stop) ? (says_something(stop) ? 1 : 0) : text.IsNumber(stop) ? 2 : 1;
      }
      // A number, a piece or a place that nothing was made of is told in whatever company.
      if (asked &&
          (plainly || ((denied || place) && stop - i >= kFewest) || (stop - i >= kFewest && saying >= kFewestSaying)))
        tell(i, stop);
    }
  }
  return all;
}

}  // namespace flair::language
