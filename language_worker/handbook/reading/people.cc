// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/people.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

namespace flair::language {
namespace {

constexpr std::size_t kMostAdverbs = 4;
constexpr std::size_t kMostBeforePersons = 2;
constexpr double kMostCounted = 2000;

// Who is counted without a word like "for".
constexpr std::array<std::string_view, 79> kPersons = {
    "people",      "person",         "adult",     "child",     "children",    "kid",       "guest",     "friend",
    "student",     "pupil",          "reader",    "visitor",   "worker",      "employee",  "colleague", "developer",
    "diner",       "player",         "patient",   "client",    "customer",    "member",    "resident",  "tenant",
    "teenager",    "toddler",        "infant",    "baby",      "senior",      "woman",     "women",     "man",
    "men",         "girl",           "boy",       "sister",    "brother",     "musician",  "singer",    "dancer",
    "worshipper",  "parishioner",    "attendee",  "delegate",  "participant", "listener",  "spectator", "viewer",
    "drinker",     "monk",           "nun",       "nurse",     "doctor",      "engineer",  "designer",  "programmer",
    "researcher",  "scientist",      "artist",    "painter",   "writer",      "trainee",   "learner",   "teacher",
    "schoolchild", "schoolchildren", "passenger", "soldier",   "sailor",      "traveller", "traveler",  "backpacker",
    "staff",       "roommate",       "flatmate",  "housemate", "partner",     "seat",      "place"};
// What such an ending makes of things.
constexpr std::array<std::string_view, 30> kThings = {
    "meters",  "metres",    "liters",     "litres",   "computers", "towers",   "servers", "containers",
    "flowers", "corners",   "quarters",   "numbers",  "papers",    "posters",  "letters", "layers",
    "floors",  "doors",     "colors",     "mirrors",  "monitors",  "elements", "events",  "instruments",
    "plants",  "documents", "apartments", "printers", "dollars",   "timers"};
constexpr std::array<std::string_view, 13> kEndings = {"ers",   "ors",  "ists",  "ians",  "ees",   "ants", "ents",
                                                       "mates", "folk", "goers", "owers", "women", "men"};
constexpr std::array<std::string_view, 13> kAdverbs = {
    "about", "around", "some", "up", "to", "at", "least", "roughly", "over", "circa", "ca", "approximately", "nearly"};
// Before a number of people.
constexpr std::array<std::string_view, 23> kHolds = {
    "seats",         "seat",   "seating", "sits",  "sleeps", "sleep",  "accommodates", "accommodate",
    "accommodating", "holds",  "hold",    "hosts", "host",   "serves", "serve",        "capacity",
    "party",         "family", "group",   "class", "team",   "staff",  "crew"};

bool NamesPerson(std::string_view word) {
  return std::ranges::any_of(kPersons, [&](std::string_view one) { return MatchesWord(word, one); });
}

// "readers", "gardeners": of whom an unknown word in "for six ..." most likely speaks.
bool SoundsLikePersons(std::string_view word) {
  return word.size() > 5 && !IncludesWord(kThings, word) &&
         std::ranges::any_of(kEndings, [&](std::string_view ending) { return word.ends_with(ending); });
}

class PeopleReader {
 public:
  PeopleReader(const std::vector<Token>& tokens, std::vector<bool>& used) : tokens_(tokens), used_(used) {}

  std::optional<int> Read() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (used_[i]) continue;
      const bool purpose = Word(i) == "for";
      const bool holds = IncludesWord(kHolds, Word(i));
      if (purpose || holds) {
        if (const std::optional<int> number = Introduced(i + 1, purpose)) return number;
      }
      if (const std::optional<int> number = NumberOfPersons(i)) return number;
    }
    return std::nullopt;
  }

 private:
  std::string_view Word(std::size_t i) const {
    return i < tokens_.size() ? std::string_view(tokens_[i].text) : std::string_view();
  }

  bool Ends(std::size_t i) const {
    constexpr std::array<std::string_view, 10> kEnds = {"and", "with", "near", "who", "that",
                                                        "in",  "at",   "to",   "on",  "or"};
    return i >= tokens_.size() ||
           (tokens_[i].kind == Token::Kind::kSign && tokens_[i].text != "-" && tokens_[i].text != "'" &&
            tokens_[i].text != "\"") ||
           IncludesWord(kEnds, Word(i));
  }

  std::optional<int> NumberAt(std::size_t i) const {
    if (i >= tokens_.size() || used_[i]) return std::nullopt;
    const Token& token = tokens_[i];
    if (token.kind == Token::Kind::kNumber) {
      const bool whole = token.number >= 1 && token.number <= kMostCounted && token.number == std::floor(token.number);
      return whole ? std::optional<int>(static_cast<int>(token.number)) : std::nullopt;
    }
    if (token.text == "a" || token.text == "an" || token.text == "several" || token.text == "both") return std::nullopt;
    return NumberWord(token.text);
  }

  // Behind "for", "seats", "a family of": a number that ends its phrase or counts whom it is for.
  std::optional<int> Introduced(std::size_t at, bool purpose) {
    const std::size_t start = at;
    constexpr std::array<std::string_view, 8> kOver = {"of", "for", "a", "an", "the", "groups", "group", "room"};
    while (at < start + kMostAdverbs && (IncludesWord(kAdverbs, Word(at)) || IncludesWord(kOver, Word(at)))) ++at;
    const std::optional<int> number = NumberAt(at);
    if (!number) return std::nullopt;
    if (Ends(at + 1)) return Take(start - 1, at + 1, *number);
    for (std::size_t noun = at + 1; noun <= at + 1 + kMostBeforePersons && noun < tokens_.size(); ++noun) {
      if (tokens_[noun].text == "-" && tokens_[noun].glued) continue;
      if (tokens_[noun].kind != Token::Kind::kWord || Ends(noun)) break;
      if (NamesPerson(Word(noun)) || (purpose && SoundsLikePersons(Word(noun)))) {
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
    for (std::size_t noun = i + 1; noun <= i + 1 + kMostBeforePersons && noun < tokens_.size(); ++noun) {
      if (tokens_[noun].text == "-" && tokens_[noun].glued) continue;
      if (tokens_[noun].kind != Token::Kind::kWord || used_[noun] || Ends(noun)) break;
      if (!NamesPerson(Word(noun))) continue;
      if (*number < 2) return std::nullopt;
      return Take(i, noun + 1, WithOthers(noun + 1, *number).value_or(*number));
    }
    return std::nullopt;
  }

  // "... and three children": they come on top.
  std::optional<int> WithOthers(std::size_t at, int number) const {
    if (Word(at) != "and") return std::nullopt;
    ++at;
    while (Word(at) == "their" || Word(at) == "her" || Word(at) == "his") ++at;
    std::optional<int> more = NumberAt(at);
    if (!more && (Word(at) == "a" || Word(at) == "an")) more = 1;
    if (!more || !NamesPerson(Word(at + 1)) || Word(at + 1) == "seats") return std::nullopt;
    return number + *more;
  }

  int Take(std::size_t begin, std::size_t end, int number) {
    std::fill(used_.begin() + static_cast<std::ptrdiff_t>(begin), used_.begin() + static_cast<std::ptrdiff_t>(end),
              true);
    return number;
  }

  const std::vector<Token>& tokens_;
  std::vector<bool>& used_;
};

}  // namespace

std::optional<int> ReadPeople(const std::vector<Token>& tokens, std::vector<bool>& used) {
  return PeopleReader(tokens, used).Read();
}

}  // namespace flair::language
