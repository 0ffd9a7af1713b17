// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/piece_count.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "language_worker/handbook/reading/sayings.h"
#include "language_worker/handbook/reading/vocabulary.h"

namespace flair::language {
namespace {

// "three-seat", "2 seater", "six-drawer", "ten-foot", "65-inch", "2 m long": how large a piece is, not how many of it.
bool MeasuresThePiece(const std::vector<Token>& tokens, std::size_t i) {
  constexpr std::array<std::string_view, 33> kMeasures = {
      "seat",  "seats", "seater", "person", "drawer", "door",  "tier", "piece", "leg",    "legged", "poster",
      "bulb",  "arm",   "armed",  "burner", "panel",  "shelf", "foot", "feet",  "ft",     "m",      "metre",
      "meter", "cm",    "mm",     "inch",   "inches", "\"",    "'",    "litre", "string", "bay",    "light"};
  if (tokens[i].kind != Token::Kind::kNumber && !NumberWord(tokens[i].text)) return false;
  std::size_t next = i + 1;
  if (next < tokens.size() && tokens[next].text == "-" && tokens[next].glued) ++next;
  const bool one = tokens[i].text == "a" || tokens[i].text == "an";
  return !one && next < tokens.size() && IncludesWord(kMeasures, tokens[next].text);
}

}  // namespace

bool IsArticle(std::string_view word) { return word == "a" || word == "an" || word == "the"; }

bool AsksForFew(const std::vector<Token>& tokens, std::size_t i) {
  static const std::vector<Phrase> kFew = {Phrase("not too many"), Phrase("not many"),   Phrase("not so many"),
                                           Phrase("hardly any"),   Phrase("barely any"), Phrase("few"),
                                           Phrase("as few")};
  constexpr std::size_t kMostBack = 4;
  for (std::size_t back = 1; back <= kMostBack && back <= i; ++back) {
    const std::size_t at = i - back;
    if (tokens[at].kind == Token::Kind::kSign || tokens[at].text == "and" || tokens[at].text == "with") return false;
    const bool some = at > 0 && (tokens[at - 1].text == "a" || tokens[at - 1].text == "quite");
    for (const Phrase& few : kFew) {
      const std::size_t length = few.MatchAt(tokens, at, /*plural=*/false);
      if (length > 0 && at + length <= i && !some) return true;
    }
  }
  return false;
}

bool IsFurther(const std::vector<Token>& tokens, std::size_t i) {
  for (std::size_t back = 1; back <= 3 && back <= i; ++back) {
    const std::string& word = tokens[i - back].text;
    if (word == "another" || word == "second" || word == "further" || word == "additional") return true;
    if (tokens[i - back].kind == Token::Kind::kSign || word == "and" || word == "with" || IsArticle(word)) break;
  }
  return false;
}

bool IsMeasure(const std::vector<Token>& tokens, std::size_t i) {
  return i >= 2 && tokens[i].glued && tokens[i - 1].text == "-" && MeasuresThePiece(tokens, i - 2);
}

bool SeatsFollow(const std::vector<Token>& tokens, std::size_t i) {
  if (i + 1 >= tokens.size() || (tokens[i].text != "for" && tokens[i].text != "with")) return false;
  const bool number =
      tokens[i + 1].kind == Token::Kind::kNumber || (!IsArticle(tokens[i + 1].text) && NumberWord(tokens[i + 1].text));
  if (!number) return false;
  return tokens[i].text == "for" || (i + 2 < tokens.size() && (MatchesWord(tokens[i + 2].text, "chair") ||
                                                               MatchesWord(tokens[i + 2].text, "seat")));
}

int SeatsAfter(const std::vector<Token>& tokens, std::size_t i) {
  if (i + 1 >= tokens.size() || tokens[i].text != "for") return 0;
  const Token& token = tokens[i + 1];
  if (IsArticle(token.text)) return 0;
  const int number = token.kind == Token::Kind::kNumber ? static_cast<int>(std::min(token.number, 1e6))
                                                        : NumberWord(token.text).value_or(0);
  // What may follow: "for six by the window". A number with another behind it is a size.
  constexpr std::array<std::string_view, 22> kNext = {
      "and",    "with",   "near",    "by",       "next", "in",    "on", "at",    "under", "beside", "against",
      "behind", "facing", "between", "opposite", "to",   "along", "or", "close", "that",  "which",  "below"};
  const bool by_size = i + 3 < tokens.size() && tokens[i + 3].kind == Token::Kind::kNumber;
  const bool ends = i + 2 == tokens.size() || tokens[i + 2].kind == Token::Kind::kSign ||
                    CountsPeople(tokens[i + 2].text) || (IncludesWord(kNext, tokens[i + 2].text) && !by_size);
  return ends && number <= kMostSeats ? number : 0;
}

Rows RowsAround(const std::vector<Token>& tokens, std::size_t i, std::size_t length) {
  constexpr std::size_t kMostWords = 4, kPhrase = 4;
  const auto number = [&](std::size_t k) {
    if (tokens[k].kind == Token::Kind::kNumber) return static_cast<int>(std::clamp(tokens[k].number, 0.0, 100.0));
    return IsArticle(tokens[k].text) ? 0 : NumberWord(tokens[k].text).value_or(0);
  };
  const auto rows_at = [&](std::size_t k) {
    if (k + kPhrase > tokens.size() || !MatchesWord(tokens[k + 1].text, "row") || tokens[k + 2].text != "of") return 0;
    return number(k) * number(k + 3);
  };
  const std::size_t end = i + length;
  std::vector<std::size_t> starts;
  for (std::size_t back = kPhrase; back <= kPhrase + kMostWords && back <= i; ++back) starts.push_back(i - back);
  if (end < tokens.size() && tokens[end].text == "in") starts.push_back(end + 1);
  for (const std::size_t start : starts) {
    const int rows = rows_at(start);
    if (rows > 0) return {rows, start, start + kPhrase};
  }
  return {};
}

PieceCount CountBefore(const Handbook& handbook, const std::vector<Token>& tokens, const hb::Furniture& furniture,
                       std::size_t i, std::size_t length) {
  if (AsksForFew(tokens, i)) return {1};
  for (std::size_t back = 1; back <= 3 && back <= i; ++back) {
    const std::size_t at = i - back;
    const Token& token = tokens[at];
    if (MeasuresThePiece(tokens, at)) continue;
    if (token.kind == Token::Kind::kNumber) {
      const double number = std::min(token.number, 1e6);
      return {number >= 1 && number == std::floor(number) ? static_cast<int>(number) : 1};
    }
    // "A few" is more than "a".
    std::pair<std::size_t, int> longest = {0, 0};
    for (const hb::CountWord& word : handbook.contents().count_words()) {
      for (const std::string& text : word.words()) {
        const std::size_t said = Phrase(text).MatchAt(tokens, at, false);
        if (said > longest.first && at + said <= i && word.count() > 0) longest = {said, word.count()};
      }
    }
    if (longest.first > 0) return {longest.second};
    // "a pair of": the article belongs to the pair, which stands after it.
    if (const std::optional<int> number = NumberWord(token.text)) return {*number};
    if (token.kind == Token::Kind::kSign && token.text != "-") break;
    if (token.text == "and" || token.text == "with" || token.text == "the") break;
  }
  const std::string& last = tokens[i + length - 1].text;
  const bool plural = furniture.plural() != furniture.name() && last.ends_with('s') && !last.ends_with("ss") &&
                      BestAt(handbook.vocabulary().names, tokens, i, /*plural=*/false, [](const hb::Furniture&) {
                        return 0;
                      }).second < length;
  return plural ? PieceCount{2, false} : PieceCount{};
}

}  // namespace flair::language
