// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/piece_words.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "language_worker/handbook/reading/other_words.h"
#include "language_worker/handbook/reading/vocabulary.h"

namespace flair::language {

namespace {

// "6", "six"; 0 for articles and other words.
int CountAt(const std::vector<Token>& tokens, std::size_t i) {
  constexpr double kMost = 1e6;
  if (i >= tokens.size() || IsArticle(tokens[i].text)) return 0;
  const bool digits = tokens[i].kind == Token::Kind::kNumber;
  return digits ? static_cast<int>(std::clamp(std::ceil(tokens[i].number), 0.0, kMost))
                : NumberWord(tokens[i].text).value_or(0);
}

// "three-seat", "2 seater", "six-drawer", "ten-foot", "65-inch", "2 m long": how large a piece is, not how many of it.
bool MeasuresThePiece(const std::vector<Token>& tokens, std::size_t i) {
  std::size_t next = i + 1;
  if (next < tokens.size() && tokens[next].text == "-" && tokens[next].glued) ++next;
  return CountAt(tokens, i) > 0 && next < tokens.size() && IsIn("piece_measures", tokens[next].text);
}

}  // namespace

bool IsArticle(std::string_view word) { return word == "a" || word == "an" || word == "the"; }

bool AsksForFew(const std::vector<Token>& tokens, std::size_t i) {
  constexpr std::size_t kMostBack = 4;
  for (std::size_t back = 1; back <= kMostBack && back <= i; ++back) {
    const std::size_t at = i - back;
    if (tokens[at].kind == Token::Kind::kSign || tokens[at].text == "and" || tokens[at].text == "with") return false;
    const bool some = at > 0 && (tokens[at - 1].text == "a" || tokens[at - 1].text == "quite");
    for (const Phrase& few : PhrasesOf("few_phrases")) {
      const std::size_t length = few.MatchAt(tokens, at, /*plural=*/false);
      if (length > 0 && at + length <= i && !some) return true;
    }
  }
  return false;
}

std::optional<std::size_t> PhraseBefore(std::string_view list, const std::vector<Token>& tokens, std::size_t i) {
  constexpr std::size_t kMostBack = 7;
  const BriefText text(tokens);
  for (std::size_t at = i; at > 0 && at + kMostBack > i; --at) {
    if (text.IsSign(at - 1) && !text.IsHyphen(at - 1)) break;
    if (text.Is(at - 1, "thing_articles") || text.Says(at - 1, {"the", "and", "with"})) break;
    if (const auto end = text.BehindPhrase(at - 1, list); end && *end <= i) return at - 1;
  }
  return std::nullopt;
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

// The index of the number of those who sit at a table, behind "for", "seating", "to seat" and the like; 0 for none.
std::size_t SeatsNumberAt(const std::vector<Token>& tokens, std::size_t i) {
  const BriefText text(tokens);
  const std::optional<std::size_t> end = text.BehindPhrase(i, "before_seats");
  return end && CountAt(tokens, *end) > 0 ? *end : 0;
}

bool IsOneForEach(const std::vector<Token>& tokens, const std::vector<bool>& used, std::size_t i, std::size_t length) {
  constexpr std::size_t kMostWords = 5, kMostBack = 4;
  const BriefText text(tokens);
  for (std::size_t back = 1; back <= kMostBack && back < i; ++back) {
    if (text.Says(i - back, {"with", "has"}) && text.Says(i - back - 1, {"each", "every"})) return true;
  }
  for (std::size_t k = i + length; k < i + length + kMostWords && k < tokens.size() && !text.IsSign(k); ++k) {
    if (used[k] || text.Says(k, {"and", "with"})) break;
    if (!text.Says(k, {"each", "every"}) || text.Says(k + 1, {"side", "end", "wall", "corner"})) continue;
    if (text.Says(k + 1, {"one", "of", "table", "desk", "bed", "seat"}) || k + 1 >= tokens.size() ||
        text.IsSign(k + 1) || text.Is(k + 1, "thing_ends")) {
      return true;
    }
  }
  return false;
}

bool SeatsFollow(const std::vector<Token>& tokens, std::size_t i) {
  if (SeatsNumberAt(tokens, i) > 0) return true;
  if (CountAt(tokens, i + 1) == 0) return false;
  const bool seats =
      i + 2 < tokens.size() && (MatchesWord(tokens[i + 2].text, "chair") || MatchesWord(tokens[i + 2].text, "seat"));
  return tokens[i].text == "with" && seats;
}

int SeatsAfter(const std::vector<Token>& tokens, std::size_t i) {
  const std::size_t at = SeatsNumberAt(tokens, i);
  const int number = at > 0 ? CountAt(tokens, at) : 0;
  if (number == 0) return 0;
  // What may follow: "for six by the window". A number with another behind it is a size.
  const bool by_size = at + 2 < tokens.size() && tokens[at + 2].kind == Token::Kind::kNumber;
  const bool ends = at + 1 == tokens.size() || tokens[at + 1].kind == Token::Kind::kSign ||
                    CountsPeople(tokens[at + 1].text) || (IsIn("after_seats", tokens[at + 1].text) && !by_size);
  return ends && number <= kMostSeats ? number : 0;
}

Rows RowsAround(const std::vector<Token>& tokens, std::size_t i, std::size_t length) {
  constexpr std::size_t kMostWords = 4, kPhrase = 4;
  constexpr int kUsualInARow = 2;
  const auto number = [&](std::size_t k) { return std::min(CountAt(tokens, k), 100); };
  const auto rows_at = [&](std::size_t k) {
    if (k + kPhrase > tokens.size() || !MatchesWord(tokens[k + 1].text, "row") || tokens[k + 2].text != "of") return 0;
    return number(k) * number(k + 3);
  };
  // "Eight rows of pews", "two rows of recliners, four each".
  const auto each_behind = [&](std::size_t k) {
    for (std::size_t at = k; at < std::min(k + kMostWords, tokens.size()); ++at) {
      const std::size_t end = std::min(at + kMostWords, tokens.size());
      for (std::size_t each = at + 1; each < end && number(at) > 0; ++each) {
        if (tokens[each].text == "each" || tokens[each].text == "per") return number(at);
      }
    }
    return 0;
  };
  const std::size_t end = i + length;
  std::vector<std::size_t> starts;
  for (std::size_t back = kPhrase; back <= kPhrase + kMostWords && back <= i; ++back) starts.push_back(i - back);
  if (end < tokens.size() && tokens[end].text == "in") starts.push_back(end + 1);
  for (const std::size_t start : starts) {
    const int rows = rows_at(start);
    if (rows > 0) return {rows, start, start + kPhrase};
  }
  for (std::size_t back = 3; back <= 3 + kMostWords && back <= i; ++back) {
    const std::size_t start = i - back;
    if (number(start) == 0 || !MatchesWord(tokens[start + 1].text, "row") || tokens[start + 2].text != "of") continue;
    const int each = each_behind(end);
    return {number(start) * (each > 0 ? each : kUsualInARow), start, start + 3};
  }
  return {};
}

PieceCount CountBefore(const Handbook& handbook, const std::vector<Token>& tokens, const hb::Furniture& furniture,
                       std::size_t i, std::size_t length) {
  if (AsksForFew(tokens, i)) return {1};
  // "Somewhere for forty pairs of shoes" is one piece.
  for (std::size_t back = 2; back <= 4 && back <= i; ++back) {
    const bool pairs = tokens[i - back].text == "pairs" && tokens[i - back + 1].text == "of";
    if (pairs && CountAt(tokens, i - back - (back < i ? 1 : 0)) > 2) return {1};
  }
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

std::string LastWord(const std::string& name) { return name.substr(name.rfind(' ') + 1); }

bool RefuseKind(const Handbook& handbook, const std::vector<Token>& tokens, std::size_t i, BriefFacts& facts) {
  bool any = false;
  for (const hb::Furniture& other : handbook.contents().furniture()) {
    const std::string last = LastWord(other.name());
    // Planters and bonsai are plants too.
    const bool same = Phrase(last).MatchAt(tokens, i) == 1 || MatchesWord(tokens[i].text, other.category());
    const bool compound = last.size() > 5 && last.ends_with("chair") && Phrase("chair").MatchAt(tokens, i) == 1;
    if (same || compound) AddOnce(facts.refusals, &other);
    any = any || same || compound;
  }
  return any;
}

bool IsRefused(const std::vector<Token>& tokens, std::size_t i) {
  const BriefText text(tokens);
  // "Please leave the rug out", "washing machine not in here".
  constexpr std::size_t kMostBehind = 3;
  for (std::size_t at = i + 1; at <= i + kMostBehind && at < tokens.size() && !text.EndsSentence(at); ++at) {
    if (text.BehindPhrase(at, "refused_behind")) return true;
    const bool left_out =
        text.At(at) == "out" && i >= 1 && (text.At(i - 1) == "leave" || (i >= 2 && text.At(i - 2) == "leave"));
    if (left_out) return true;
    if (text.IsSign(at) && !text.IsHyphen(at)) break;
  }
  for (const std::size_t back : {1, 2, 3}) {
    if (back <= i && text.BehindPhrase(i - back, "refused_before").value_or(0) >= i - back + 2) return true;
  }
  for (std::size_t back = 1; back <= 4 && back <= i; ++back) {
    const std::string& word = tokens[i - back].text;
    const std::string_view before = back < i ? std::string_view(tokens[i - back - 1].text) : std::string_view();
    if (IsIn("place_prepositions", word)) return false;
    if ((word == "of" && before == "instead") || (word == "than" && before == "rather")) return true;
    if (word == "than") return false;
    if (word == "no" || word == "without" || word == "not") return true;
    if (word == "," || word == "." || word == ";" || word == "with" || word == "but" || word == "and") return false;
  }
  return false;
}

bool IsOptional(const std::vector<Token>& tokens, const std::vector<bool>& used, std::size_t begin, std::size_t end) {
  constexpr std::size_t kMostWords = 8, kMostBefore = 5;
  const auto says = [&](const std::vector<Phrase>& phrases, std::size_t at) {
    return std::ranges::any_of(phrases, [&](const Phrase& one) { return one.MatchAt(tokens, at, false) > 0; });
  };
  for (std::size_t at = end; at < tokens.size() && at < end + kMostWords; ++at) {
    if (says(PhrasesOf("optional_behind"), at)) return true;
    const std::string& word = tokens[at].text;
    const bool comma = word == "," && at + 1 < tokens.size() && says(PhrasesOf("optional_behind"), at + 1);
    if ((tokens[at].kind == Token::Kind::kSign && !comma && word != "(") || word == "and" || word == "with") break;
  }
  for (std::size_t back = 1; back <= kMostBefore && back <= begin; ++back) {
    const std::size_t at = begin - back;
    if (says(PhrasesOf("optional_before"), at)) return true;
    if (tokens[at].kind == Token::Kind::kSign && tokens[at].text != ",") break;
    if (tokens[at].text == "and" || tokens[at].text == "with" || tokens[at].text == "is" || used[at]) break;
  }
  return false;
}

bool AsksForNothingElse(const Handbook& handbook, const std::vector<Token>& tokens) {
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    const std::string &word = tokens[i].text, &next = tokens[i + 1].text;
    const bool negated = i > 0 && (tokens[i - 1].text == "not" || tokens[i - 1].text == "if");
    const bool counts = NumberWord(next) || IsArticle(next) || tokens[i + 1].kind == Token::Kind::kNumber;
    if ((word == "only" || word == "just") && !negated && counts) {
      // "only 3 m wide", "only one window": of the room.
      const std::size_t end = std::min(i + 5, tokens.size());
      for (std::size_t k = i + 2; k < end; ++k) {
        if (LongestAt(handbook.vocabulary().names, tokens, k, /*plural=*/true).second > 0) return true;
        if (tokens[k].kind == Token::Kind::kSign || tokens[k].text == "with" || tokens[k].text == "for") break;
      }
    }
    if (word == "nothing" && (next == "but" || next == "else")) return true;
  }
  return false;
}

bool IsSeat(const hb::Furniture& furniture) {
  return furniture.category() == "chair" || furniture.category() == "stool";
}

const hb::Furniture* SeatOf(const hb::Furniture& furniture, const Handbook& handbook) {
  for (const hb::ObjectEntry& companion : furniture.companions()) {
    const hb::Furniture* seat = handbook.FindFurniture(companion.furniture());
    if (seat != nullptr && (IsSeat(*seat) || seat->category() == "bench")) return seat;
  }
  return nullptr;
}

bool StandsWith(const hb::Furniture& furniture, const hb::Furniture& partner) {
  const auto names = [&](const auto& list) { return std::ranges::find(list, partner.name()) != list.end(); };
  return names(furniture.hosts()) ||
         std::ranges::any_of(furniture.relations(), [&](const hb::Relation& one) { return names(one.targets()); });
}

}  // namespace flair::language
