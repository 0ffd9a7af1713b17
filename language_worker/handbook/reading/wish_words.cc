// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/wish_words.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "language_worker/handbook/reading/piece_count.h"
#include "language_worker/handbook/reading/sayings.h"
#include "language_worker/handbook/reading/vocabulary.h"

namespace flair::language {

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
  constexpr std::array<std::string_view, 21> kPlaces = {
      "near",     "next",  "by",    "facing",  "in",   "on",    "at",      "under", "beside", "against", "behind",
      "opposite", "close", "below", "beneath", "from", "above", "between", "too",   "front",  "many"};
  for (std::size_t back = 1; back <= 4 && back <= i; ++back) {
    const std::string& word = tokens[i - back].text;
    const std::string_view before = back < i ? std::string_view(tokens[i - back - 1].text) : std::string_view();
    if (IncludesWord(kPlaces, word)) return false;
    if ((word == "of" && before == "instead") || (word == "than" && before == "rather")) return true;
    if (word == "than") return false;
    if (word == "no" || word == "without" || word == "not") return true;
    if (word == "," || word == "." || word == ";" || word == "with" || word == "but" || word == "and") return false;
  }
  return false;
}

bool IsOptional(const std::vector<Token>& tokens, const std::vector<bool>& used, std::size_t begin, std::size_t end) {
  static const std::vector<Phrase> kBehind = {Phrase("if there is room"),
                                              Phrase("if there s room"),
                                              Phrase("if there is space"),
                                              Phrase("if there s space"),
                                              Phrase("if there is any room"),
                                              Phrase("if there is enough room"),
                                              Phrase("if there is enough space"),
                                              Phrase("if it fits"),
                                              Phrase("if they fit"),
                                              Phrase("if possible"),
                                              Phrase("if needed"),
                                              Phrase("if space allows"),
                                              Phrase("if room allows"),
                                              Phrase("if space permits"),
                                              Phrase("space permitting"),
                                              Phrase("room permitting"),
                                              Phrase("where it fits"),
                                              Phrase("would be nice"),
                                              Phrase("would be a bonus"),
                                              Phrase("if you can"),
                                              Phrase("if you can fit"),
                                              Phrase("as an option"),
                                              Phrase("if at all possible"),
                                              Phrase("optional"),
                                              Phrase("if necessary"),
                                              Phrase("if we have room"),
                                              Phrase("if room remains")};
  static const std::vector<Phrase> kBefore = {
      Phrase("perhaps"),    Phrase("maybe"),       Phrase("possibly"),         Phrase("optional"),
      Phrase("optionally"), Phrase("if possible"), Phrase("if there is room"), Phrase("if there is space"),
      Phrase("ideally")};
  constexpr std::size_t kMostWords = 8, kMostBefore = 5;
  const auto says = [&](const std::vector<Phrase>& phrases, std::size_t at) {
    return std::ranges::any_of(phrases, [&](const Phrase& one) { return one.MatchAt(tokens, at, false) > 0; });
  };
  for (std::size_t at = end; at < tokens.size() && at < end + kMostWords; ++at) {
    if (says(kBehind, at)) return true;
    const std::string& word = tokens[at].text;
    const bool comma = word == "," && at + 1 < tokens.size() && says(kBehind, at + 1);
    if ((tokens[at].kind == Token::Kind::kSign && !comma && word != "(") || word == "and" || word == "with") break;
  }
  for (std::size_t back = 1; back <= kMostBefore && back <= begin; ++back) {
    const std::size_t at = begin - back;
    if (says(kBefore, at)) return true;
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

}  // namespace flair::language
