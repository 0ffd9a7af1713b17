// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/words.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace flair::language {
namespace {

// Signs of more than one byte that people type, and what they stand for.
constexpr std::array<std::pair<std::string_view, char>, 12> kTypography = {{
    {"\u2018", '\''},
    {"\u2019", '\''},
    {"\u2032", '\''},
    {"\u201c", '"'},
    {"\u201d", '"'},
    {"\u2033", '"'},
    {"\u00d7", 'x'},
    {"\u2013", '-'},
    {"\u2014", '-'},
    {"\u2212", '-'},
    {"\u00b2", '2'},
    {"\u00a0", ' '},
}};

std::string PlainText(std::string_view text) {
  std::string plain;
  plain.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    bool replaced = false;
    if (static_cast<unsigned char>(text[i]) >= 0x80) {
      for (const auto& [from, to] : kTypography) {
        if (text.substr(i, from.size()) != from) continue;
        plain += to;
        i += from.size();
        replaced = true;
        break;
      }
    }
    if (!replaced) plain += static_cast<char>(std::tolower(static_cast<unsigned char>(text[i++])));
  }
  return plain;
}

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

// Letters, and the bytes of letters beyond ASCII.
bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80; }

Token ReadNumber(const std::string& text, std::size_t& i) {
  std::string digits;
  bool decimal = false;
  // More digits than any size has would only lose precision.
  while (i < text.size()) {
    const bool point = (text[i] == '.' || text[i] == ',') && !decimal && i + 1 < text.size() && IsDigit(text[i + 1]);
    if (!IsDigit(text[i]) && !point) break;
    decimal = decimal || point;
    digits += point ? '.' : text[i];
    ++i;
  }
  return {Token::Kind::kNumber, digits, std::strtod(digits.c_str(), nullptr), false};
}

template <std::size_t n>
int NumberOf(const std::array<std::string_view, n>& names, std::string_view word) {
  return static_cast<int>(std::find(names.begin(), names.end(), word) - names.begin());
}

// "forty", "twenty-five", "twenty five", "a hundred" as numbers, as if written in digits; up to twelve they stay words.
std::vector<Token> WithLargeNumbers(const std::vector<Token>& tokens) {
  constexpr std::array<std::string_view, 7> kTeens = {"thirteen",  "fourteen", "fifteen", "sixteen",
                                                      "seventeen", "eighteen", "nineteen"};
  constexpr std::array<std::string_view, 8> kTens = {"twenty", "thirty",  "forty",  "fifty",
                                                     "sixty",  "seventy", "eighty", "ninety"};
  constexpr std::array<std::string_view, 9> kUnits = {"one", "two",   "three", "four", "five",
                                                      "six", "seven", "eight", "nine"};
  // 1 to 9, or 0 for any other word.
  const auto ones_of = [&](std::string_view word) { return (NumberOf(kUnits, word) + 1) % 10; };
  std::vector<Token> result;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const bool glued = tokens[i].glued;
    int number = 0;
    if (const int teen = NumberOf(kTeens, tokens[i].text); teen < 7) number = 13 + teen;
    if (const int ten = NumberOf(kTens, tokens[i].text); ten < 8) {
      number = 20 + 10 * ten;
      const std::size_t next = i + (i + 1 < tokens.size() && tokens[i + 1].text == "-" ? 2 : 1);
      if (const int ones = next < tokens.size() ? ones_of(tokens[next].text) : 0; ones > 0) {
        number += ones;
        i = next;
      }
    } else if (tokens[i].text == "hundred") {
      const std::string before = result.empty() ? "" : result.back().text;
      number = 100 * std::max(1, ones_of(before));
      if (before == "a" || ones_of(before) > 0) result.pop_back();
    }
    if (number == 0) {
      result.push_back(tokens[i]);
    } else {
      result.push_back({Token::Kind::kNumber, std::to_string(number), static_cast<double>(number), glued});
    }
  }
  return result;
}

}  // namespace

std::vector<Token> Tokenize(std::string_view text) {
  const std::string plain = PlainText(text);
  std::vector<Token> tokens;
  for (std::size_t i = 0; i < plain.size();) {
    const bool glued = i > 0 && !std::isspace(static_cast<unsigned char>(plain[i - 1]));
    const std::size_t before = tokens.size();
    if (IsDigit(plain[i])) {
      tokens.push_back(ReadNumber(plain, i));
    } else if (IsLetter(plain[i])) {
      std::string word;
      while (i < plain.size() && IsLetter(plain[i])) {
        word += plain[i++];
        // "4x5", "4mx5m": an x before a digit is a sign of its own, not part of a word.
        const bool times = i + 1 < plain.size() && plain[i] == 'x' && IsDigit(plain[i + 1]);
        const bool unit = word == "m" || word == "cm" || word == "mm" || word == "ft";
        if ((word == "x" && i < plain.size() && IsDigit(plain[i])) || (times && unit)) break;
      }
      tokens.push_back({Token::Kind::kWord, std::move(word), 0, false});
    } else {
      if (!std::isspace(static_cast<unsigned char>(plain[i]))) {
        tokens.push_back({Token::Kind::kSign, std::string(1, plain[i]), 0, false});
      }
      ++i;
    }
    if (tokens.size() > before) tokens.back().glued = glued;
  }
  return WithLargeNumbers(tokens);
}

std::optional<int> NumberWord(std::string_view word) {
  constexpr std::array<std::pair<std::string_view, int>, 19> kNumbers = {{
      {"a", 1},    {"an", 1},    {"one", 1},    {"two", 2},    {"three", 3},   {"four", 4},    {"five", 5},
      {"six", 6},  {"seven", 7}, {"eight", 8},  {"nine", 9},   {"ten", 10},    {"eleven", 11}, {"twelve", 12},
      {"both", 2}, {"pair", 2},  {"couple", 2}, {"dozen", 12}, {"several", 4},
  }};
  for (const auto& [name, number] : kNumbers) {
    if (name == word) return number;
  }
  return std::nullopt;
}

bool MatchesWord(std::string_view word, std::string_view stem) {
  if (word == stem) return true;
  if (stem.size() > 1 && stem.back() == '*') return word.substr(0, stem.size() - 1) == stem.substr(0, stem.size() - 1);
  const auto has = [&](std::string_view base, std::string_view ending) {
    return word.size() == base.size() + ending.size() && word.substr(0, base.size()) == base &&
           word.substr(base.size()) == ending;
  };
  if (stem.size() < 2) return false;
  const std::string_view cut = stem.substr(0, stem.size() - 1);
  return has(stem, "s") || has(stem, "es") || (stem.back() == 'y' && has(cut, "ies")) ||
         (stem.back() == 'f' && has(cut, "ves"));
}

bool CountsPeople(std::string_view word) {
  constexpr std::array<std::string_view, 16> kPeople = {
      "people", "person",  "guest",     "friend", "adult", "child",    "children", "kid",
      "diner",  "student", "colleague", "player", "pupil", "employee", "worker",   "visitor"};
  return std::any_of(kPeople.begin(), kPeople.end(), [&](std::string_view one) { return MatchesWord(word, one); });
}

Phrase::Phrase(std::string_view text) {
  std::size_t start = 0;
  const std::string_view separators = " -'/";
  while (start < text.size()) {
    const std::size_t end = std::min(text.find_first_of(separators, start), text.size());
    if (end > start) words_.push_back(PlainText(text.substr(start, end - start)));
    start = end + 1;
  }
}

// "barstool" for "bar stool", and "night stand" for "nightstand".
std::size_t Phrase::MatchSpelling(const std::vector<Token>& tokens, std::size_t start, bool plural) const {
  constexpr std::size_t kShortestPart = 3;
  if (words_.empty() || words_.size() > 2 || start >= tokens.size()) return 0;
  const std::string& text = tokens[start].text;
  if (tokens[start].kind != Token::Kind::kWord) return 0;
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
    // Hyphens, apostrophes and slashes inside a phrase are passed over: "bean-bag", "child's bed", "living / dining".
    while (w > 0 && at < tokens.size() && tokens[at].kind == Token::Kind::kSign &&
           (tokens[at].text == "/" || (tokens[at].glued && (tokens[at].text == "-" || tokens[at].text == "'")))) {
      ++at;
    }
    if (at >= tokens.size()) return 0;
    const Token& token = tokens[at];
    if (words_[w] == "{n}") {
      const std::optional<int> named = NumberWord(token.text);
      const bool digits = token.kind == Token::Kind::kNumber && token.number >= 1 && token.number <= 1000;
      if (!digits && !named) return 0;
      if (number != nullptr) *number = digits ? static_cast<int>(token.number) : *named;
    } else if (token.kind == Token::Kind::kNumber) {
      // "2-seater" for "two-seater".
      if (token.text != words_[w] && (words_[w].size() < 3 || NumberWord(words_[w]) != token.number)) return 0;
    } else if (token.text != words_[w] && words_[w].back() != '*' &&
               !(plural && w + 1 == words_.size() && MatchesWord(token.text, words_[w]))) {
      return 0;
    } else if (words_[w].back() == '*' && !MatchesWord(token.text, words_[w])) {
      return 0;
    }
    ++at;
  }
  return words_.empty() ? 0 : at - start;
}

bool Phrase::Occurs(const std::vector<Token>& tokens, int* number) const {
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (MatchAt(tokens, i, true, number) > 0) return true;
  }
  return false;
}

}  // namespace flair::language
