// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/words.h"

#include <cmath>
#include <map>

#include "english/language.h"
#include "english/quantities.h"
#include "english/words.h"

namespace flair::language {
namespace {

constexpr double kLeastJoined = 13;

const english::Language& English() { return english::Language::Get(); }

struct List {
  std::vector<std::string> words;
  std::vector<Phrase> phrases;
};

// Empty for names that there are not.
const List& ListOf(std::string_view name) {
  static const auto* const lists = [] {
    auto* const made = new std::map<std::string, List, std::less<>>;
    for (const auto& list : English().data().lists()) {
      for (const std::string& words : list.words()) {
        List& all = (*made)[list.name()];
        all.words.push_back(words);
        all.phrases.emplace_back(words);
      }
    }
    return made;
  }();
  static const List kNone;
  const auto found = lists->find(name);
  return found == lists->end() ? kNone : found->second;
}

// Most pairs of words are told apart by their beginnings, at no cost.
bool BeginTheSame(std::string_view a, std::string_view b) {
  constexpr std::size_t kLongestEnding = 3;
  const std::size_t shorter = std::min(a.size(), b.size());
  const std::size_t least = shorter > kLongestEnding ? shorter - kLongestEnding : 1;
  return shorter > 0 && std::max(a.size(), b.size()) <= shorter + kLongestEnding &&
         a.substr(0, least) == b.substr(0, least);
}

// The word of the compass that a letter stands for; empty for others.
std::string_view CompassOf(char letter) {
  const auto& words = WordsOf("compass");
  const auto found = std::ranges::find(words, letter, [](const std::string& word) { return word.front(); });
  return found == words.end() ? std::string_view() : *found;
}

// "The W wall", "the SW corner", "headboard to N."
void SpellOutCompass(std::vector<Token>& tokens) {
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const bool last = i + 1 == tokens.size() || tokens[i + 1].kind == Token::Kind::kSign;
    const bool before = i + 1 < tokens.size() && IsIn("behind_compass_letters", tokens[i + 1].text);
    const bool behind = last && i > 0 && IsOneOf(tokens[i - 1].text, {"to", "facing", "faces", "on", "from"});
    const std::string letters = tokens[i].text;
    const bool all = std::ranges::none_of(letters, [](char letter) { return CompassOf(letter).empty(); });
    if (tokens[i].kind != Token::Kind::kWord || tokens[i].glued || (!before && !behind)) continue;
    if (letters.empty() || letters.size() > 2 || !all) continue;
    tokens[i].text = CompassOf(letters[0]);
    if (letters.size() == 1 && !before && IsOneOf(tokens[i - 1].text, {"to", "on"})) {
      Token wall = tokens[i];
      wall.text = "wall";
      wall.glued = false;
      tokens.insert(tokens.begin() + static_cast<std::ptrdiff_t>(++i), std::move(wall));
      continue;
    }
    if (letters.size() == 1) continue;
    Token hyphen = tokens[i], second = tokens[i];
    hyphen.kind = Token::Kind::kSign;
    hyphen.text = "-";
    second.text = CompassOf(letters[1]);
    hyphen.glued = second.glued = true;
    tokens.insert(tokens.begin() + static_cast<std::ptrdiff_t>(++i), {std::move(hyphen), std::move(second)});
    ++i;
  }
}

// Who draws writes "4200 x 3800" and leaves out the unit everywhere: "window 1800 centred".
void AddMillimetres(std::vector<Token>& tokens) {
  constexpr double kLeastOfARoom = 1000, kLeast = 100, kMost = 20000;
  const auto is_bare = [&](std::size_t i, double least) {
    return i < tokens.size() && tokens[i].kind == Token::Kind::kNumber && tokens[i].number >= least &&
           tokens[i].number <= kMost && tokens[i].number == std::floor(tokens[i].number) &&
           (i + 1 == tokens.size() || English().FindUnit(tokens[i + 1].text) == nullptr);
  };
  bool drawn = false;
  for (std::size_t i = 0; i + 2 < tokens.size() && !drawn; ++i)
    drawn = is_bare(i, kLeastOfARoom) && tokens[i + 1].text == "x" && is_bare(i + 2, kLeastOfARoom);
  for (std::size_t i = 0; drawn && i < tokens.size(); ++i) {
    if (!is_bare(i, kLeast)) continue;
    Token unit;
    unit.kind = Token::Kind::kWord;
    unit.text = "mm";
    unit.begin = unit.end = tokens[i].end;
    tokens.insert(tokens.begin() + static_cast<std::ptrdiff_t>(++i), std::move(unit));
  }
}

}  // namespace

std::vector<Token> TokensOf(std::string_view text) {
  const std::vector<Token> tokens = english::Tokenize(text);
  std::vector<Token> joined;
  joined.reserve(tokens.size());
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    joined.push_back(tokens[i]);
    // "4:30" is a time.
    const bool glued = i + 2 < tokens.size() && tokens[i + 1].glued && tokens[i + 2].glued && tokens[i + 1].text == ":";
    if (glued && tokens[i].kind == Token::Kind::kNumber && tokens[i + 2].kind == Token::Kind::kNumber) {
      joined.back().kind = Token::Kind::kWord;
      i += 2;
      continue;
    }
    if (tokens[i].kind != Token::Kind::kWord) continue;
    const std::optional<english::Number> number = english::NumberAt(tokens, i);
    if (!number || number->value < kLeastJoined) continue;
    Token& token = joined.back();
    token.kind = Token::Kind::kNumber;
    token.number = number->value;
    token.text = std::to_string(static_cast<int>(number->value));
    token.end = tokens[number->end - 1].end;
    i = number->end - 1;
  }
  SpellOutCompass(joined);
  AddMillimetres(joined);
  return joined;
}

std::optional<int> NumberWord(std::string_view word) {
  const std::optional<double> number = english::NumberOf(word);
  if (!number || *number < 1 || *number != std::floor(*number)) return std::nullopt;
  return static_cast<int>(*number);
}

bool MatchesWord(std::string_view word, std::string_view base) {
  if (word == base) return true;
  if (base.size() > 1 && base.back() == '*') return word.starts_with(base.substr(0, base.size() - 1));
  return BeginTheSame(word, base) && english::IsFormOf(word, base);
}

bool IsIn(std::string_view list, std::string_view word) { return English().IsIn(list, word); }

bool IsFormIn(std::string_view list, std::string_view word) {
  return IsIn(list, word) || IsIn(list, english::Singular(word)) || IsIn(list, english::British(word));
}

Phrase::Phrase(std::string_view text) {
  bool slot = false;
  for (const Token& token : english::Tokenize(text)) {
    if (token.text == "{" || token.text == "}") {
      slot = token.text == "{";
    } else if (token.text == "*" && token.glued && !words_.empty()) {
      words_.back() += "*";
    } else if (token.kind != Token::Kind::kSign || (token.text != "-" && token.text != "'" && token.text != "/")) {
      words_.push_back(slot ? "{" + token.text + "}" : token.text);
    }
  }
  for (const std::string& word : words_) {
    const bool counts = word.size() >= 3 && !IsIn("vague_numbers", word);
    numbers_.push_back(counts ? NumberWord(word).value_or(0) : 0);
  }
}

// "barstool" for "bar stool", and "night stand" for "nightstand".
std::size_t Phrase::MatchSpelling(const std::vector<Token>& tokens, std::size_t start, bool plural) const {
  constexpr std::size_t kShortestPart = 3;
  if (words_.size() > 2 || tokens[start].kind != Token::Kind::kWord) return 0;
  const std::string& text = tokens[start].text;
  const auto matches = [&](std::string_view word, std::string_view stem) {
    return word == stem || (plural && MatchesWord(word, stem));
  };
  if (words_.size() == 2) {
    if (!text.starts_with(words_[0]) || words_[0].size() < kShortestPart || words_[1].size() < kShortestPart) return 0;
    return matches(std::string_view(text).substr(words_[0].size()), words_[1]) ? 1 : 0;
  }
  if (text.size() < kShortestPart || words_[0].size() < text.size() + kShortestPart) return 0;
  if (!words_[0].starts_with(text)) return 0;
  std::size_t next = start + 1;
  if (next < tokens.size() && tokens[next].text == "-" && tokens[next].glued) ++next;
  if (next >= tokens.size() || tokens[next].kind != Token::Kind::kWord) return 0;
  const std::string_view rest = std::string_view(words_[0]).substr(text.size());
  return matches(tokens[next].text, rest) ? next + 1 - start : 0;
}

std::size_t Phrase::MatchAt(const std::vector<Token>& tokens, std::size_t start, bool plural, int* number) const {
  // Most phrases end here: what matches begins with the same letter.
  if (start >= tokens.size() || words_.empty()) return 0;
  const bool word = tokens[start].kind == Token::Kind::kWord;
  if (word && words_[0][0] != tokens[start].text[0] && words_[0][0] != '{') return 0;
  if (const std::size_t spelt = MatchSpelling(tokens, start, plural); spelt > 0) return spelt;
  std::size_t at = start;
  for (std::size_t w = 0; w < words_.size(); ++w) {
    const std::string& wanted = words_[w];
    // Hyphens, apostrophes and slashes inside a phrase are passed over: "bean-bag", "boys' room", "living / dining".
    while (w > 0 && at < tokens.size() &&
           ((tokens[at].text == "'s" && wanted != "'s") || tokens[at].text == "/" ||
            (tokens[at].glued && (tokens[at].text == "-" || tokens[at].text == "'")))) {
      ++at;
    }
    if (at >= tokens.size()) return 0;
    const Token& token = tokens[at];
    if (wanted == "{n}") {
      const std::optional<int> named = NumberWord(token.text);
      const bool digits = token.kind == Token::Kind::kNumber && token.number >= 1 && token.number <= 1000;
      if (!digits && !named) return 0;
      if (number != nullptr) *number = digits ? static_cast<int>(token.number) : *named;
    } else if (token.kind == Token::Kind::kNumber) {
      // "2-seater" for "two-seater".
      if (token.text != wanted && (numbers_[w] == 0 || numbers_[w] != token.number)) return 0;
    } else if (token.text != wanted) {
      const bool any_form = wanted.back() == '*' || (plural && w + 1 == words_.size());
      if (!any_form || !MatchesWord(token.text, wanted)) return 0;
    }
    ++at;
  }
  return at - start;
}

bool Phrase::Occurs(const std::vector<Token>& tokens, int* number) const {
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (MatchAt(tokens, i, true, number) > 0) return true;
  }
  return false;
}

const std::vector<std::string>& WordsOf(std::string_view list) { return ListOf(list).words; }
const std::vector<Phrase>& PhrasesOf(std::string_view list) { return ListOf(list).phrases; }

std::optional<std::size_t> BriefText::Behind(std::size_t i, std::string_view phrase) const {
  const std::size_t length = Phrase(phrase).MatchAt(tokens_, i, /*plural=*/false);
  return length > 0 ? std::optional(i + length) : std::nullopt;
}

std::optional<std::size_t> BriefText::BehindPhrase(std::size_t i, std::string_view list) const {
  std::size_t longest = 0;
  for (const Phrase& phrase : PhrasesOf(list))
    longest = std::max(longest, phrase.MatchAt(tokens_, i, /*plural=*/false));
  return longest > 0 ? std::optional(i + longest) : std::nullopt;
}

std::size_t BriefText::PhraseBegin(std::size_t noun) const {
  constexpr std::size_t kMostWords = 9;
  std::size_t begin = noun;
  while (begin > 0 && noun - begin < kMostWords) {
    const std::size_t at = begin - 1;
    if (IsSign(at) && !IsHyphen(at) && !Says(at, {"'", "\""})) break;
    const bool counting = at > 0 && (NumberWord(At(at - 1)) || Is(at - 1, "rows_of"));
    const bool times = At(at) == "x" && at > 0 && IsNumber(at - 1) && !IsNumber(at + 1);
    const bool part = times || (At(at) == "of" && counting) || NumberWord(At(at)) || (at > 0 && IsHyphen(at - 1));
    const bool ends = Is(at, "thing_ends") || Is(at, "have") || Is(at, "thing_verbs") || IsFormIn("persons", At(at));
    if (IsWord(at) && Is(at, "articles")) return at;
    if (IsWord(at) && ends && !part) break;
    begin = at;
  }
  return begin;
}

std::optional<double> BriefText::LengthAt(std::size_t i, std::size_t& end) const {
  // "A metre", but not the foot of a bed.
  const bool article = Says(i, {"a", "an"});
  if (!IsNumber(i) && (!NumberWord(At(i)) || (article && !Is(i + 1, "metres")))) return std::nullopt;
  const std::optional<english::Measure> measure = english::MeasureAt(tokens_, i);
  if (!measure || measure->unit == 0) return std::nullopt;
  end = measure->end;
  return measure->value;
}

std::string BriefText::Quote(std::size_t begin, std::size_t end) const {
  std::string text;
  for (std::size_t i = begin; i < end && i < size(); ++i) {
    // The two words of "there's" are glued as well.
    const bool apart = !tokens_[i].glued || (IsWord(i) && i > 0 && IsWord(i - 1) && At(i) != "'s");
    text += (i > begin && apart ? " " : "") + tokens_[i].text;
  }
  return text;
}

}  // namespace flair::language
