// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/unknown_things.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace flair::language {
namespace {

constexpr std::size_t kMostThings = 8;
constexpr std::size_t kMostWords = 5;
constexpr std::size_t kShortText = 4;

// Shared with no other language that uses the Latin letters.
constexpr std::array<std::string_view, 17> kEnglish = {"the",  "with", "and",    "for",   "that", "my",
                                                       "by",   "room", "should", "where", "two",  "three",
                                                       "from", "this", "want",   "need",  "of"};
// Behind which things are listed.
constexpr std::array<std::string_view, 20> kBefore = {
    "with", "and",   "plus", "has",   "have", "having", "contains", "containing", "includes", "including",
    "want", "wants", "need", "needs", "like", "add",    "for",      "also",       "where",    "fits"};
constexpr std::array<std::string_view, 34> kAfter = {
    "and",     "with",  "or",      "for",      "in",     "on",     "of", "that",   "which", "by",   "near",  "next",
    "to",      "from",  "at",      "but",      "where",  "so",     "is", "are",    "under", "over", "above", "behind",
    "between", "along", "against", "opposite", "beside", "facing", "x",  "please", "as",    "who"};
constexpr std::array<std::string_view, 12> kArticles = {"a",   "an",      "some", "several", "my",  "our",
                                                        "the", "another", "lots", "many",    "his", "her"};
constexpr std::array<std::string_view, 16> kUnits = {"m",    "cm",     "mm", "metre",  "meter", "foot", "feet", "ft",
                                                     "inch", "inches", "in", "square", "sq",    "sqm",  "m2",   "by"};
// Said of a whole room, not of things in it.
constexpr std::array<std::string_view, 30> kNoThing = {
    "bit",        "lot",   "little", "touch",     "hint",  "few",   "couple",  "feel",    "feeling", "sense",
    "atmosphere", "room",  "look",   "mood",      "vibe",  "kind",  "sort",    "style",   "budget",  "view",
    "area",       "space", "place",  "character", "theme", "floor", "morning", "evening", "day",     "night"};

// Between things in a list.
constexpr std::array<std::string_view, 5> kListing = {",", "and", "with", "plus", "&"};
constexpr std::size_t kMostBareWords = 3;
// Last words of things.
constexpr std::array<std::string_view, 44> kThings = {
    "machine", "rail",     "rack",   "stand",     "unit",  "holder", "station", "trolley", "cart",
    "cabinet", "cupboard", "board",  "box",       "chest", "table",  "chair",   "bed",     "desk",
    "lamp",    "screen",   "shelf",  "bench",     "stool", "seat",   "tank",    "system",  "player",
    "warmer",  "cooler",   "heater", "dispenser", "press", "oven",   "freezer", "basket",  "bin",
    "locker",  "hook",     "pod",    "rug",       "mat",   "case",   "sofa",    "couch"};
// What follows them is no thing of the room.
constexpr std::array<std::string_view, 6> kVerbs = {"put", "place", "use", "leave", "keep", "make"};

template <typename List>
bool Lists(const List& list, std::string_view word) {
  return std::any_of(list.begin(), list.end(), [&](std::string_view one) { return MatchesWord(word, one); });
}

template <typename List>
bool Has(const List& list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

class ThingFinder {
 public:
  ThingFinder(const std::vector<Token>& tokens, const std::vector<bool>& used) : tokens_(tokens), used_(used) {}

  // The thing whose article or number is at `i`; empty when there is none that is unknown.
  std::string ThingAt(std::size_t i) const {
    if (used_[i] || !BeginsThing(i)) return "";
    std::size_t end = i + 1;
    while (end < tokens_.size() && Continues(end)) ++end;
    // The feet and inches of a size are no thing.
    if (end == i + 1 || end > i + 1 + kMostWords || tokens_[i + 1].kind == Token::Kind::kSign) return "";
    std::string text;
    for (std::size_t k = i + 1; k < end; ++k) {
      if (used_[k]) return "";
      text += (k > i + 1 && !tokens_[k].glued ? " " : "") + tokens_[k].text;
    }
    const std::string& first = tokens_[i + 1].text;
    const std::string& last = tokens_[end - 1].text;
    return Lists(kNoThing, first) || Lists(kNoThing, last) || CountsPeople(last) ? "" : text;
  }

  // The thing that is listed at `i` without an article: "a sofa, vending machine and bookshelf". Only one whose last
  // word is said of things, since an adjective may be listed as well.
  std::string BareThingAt(std::size_t i) const {
    if (i == 0 || !Has(kListing, tokens_[i - 1].text)) return "";
    std::string text;
    std::size_t end = i;
    for (; end < tokens_.size() && Continues(end) && end < i + kMostBareWords; ++end) {
      if (used_[end] || Has(kArticles, tokens_[end].text)) return "";
      text += (end > i && !tokens_[end].glued ? " " : "") + tokens_[end].text;
    }
    if (end == i || (end < tokens_.size() && Continues(end))) return "";
    return Lists(kThings, tokens_[end - 1].text) && !Has(kVerbs, tokens_[i].text) ? text : "";
  }

 private:
  bool BeginsThing(std::size_t i) const {
    const Token& token = tokens_[i];
    const bool number =
        token.kind == Token::Kind::kNumber && i + 1 < tokens_.size() && !Lists(kUnits, tokens_[i + 1].text);
    if (!number && !Has(kArticles, token.text) && !NumberWord(token.text)) return false;
    if (i == 0) return true;
    const Token& before = tokens_[i - 1];
    return before.kind == Token::Kind::kSign ? before.text != "-" && before.text != "'" : Has(kBefore, before.text);
  }

  // Words, and the hyphens in them.
  bool Continues(std::size_t i) const {
    const Token& token = tokens_[i];
    if (token.kind == Token::Kind::kSign) return (token.text == "-" || token.text == "'") && token.glued;
    return token.kind == Token::Kind::kWord && !Has(kAfter, token.text);
  }

  const std::vector<Token>& tokens_;
  const std::vector<bool>& used_;
};

}  // namespace

bool ReadsAsEnglish(const std::vector<Token>& tokens) {
  std::size_t words = 0;
  for (const Token& token : tokens) {
    if (token.kind != Token::Kind::kWord) continue;
    if (Has(kEnglish, token.text)) return true;
    words += token.text.size() > 1 ? 1 : 0;
  }
  return words <= kShortText;
}

std::vector<std::string> UnknownThings(const std::vector<Token>& tokens, const std::vector<bool>& used) {
  const ThingFinder finder(tokens, used);
  std::vector<std::string> things;
  for (std::size_t i = 0; i < tokens.size() && things.size() < kMostThings; ++i) {
    std::string thing = finder.ThingAt(i);
    if (thing.empty()) thing = finder.BareThingAt(i);
    if (!thing.empty() && !Has(things, thing)) things.push_back(std::move(thing));
  }
  return things;
}

}  // namespace flair::language
