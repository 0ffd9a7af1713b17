// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/tokens.h"

#include <array>
#include <charconv>
#include <utility>

namespace flair::language {
namespace {

// UTF-8 sequences and what they are read as.
constexpr std::array<std::pair<std::string_view, std::string_view>, 34> kPlainForms = {{
    {"\u2032", "'"}, {"\u2019", "'"}, {"\u2018", "'"}, {"\u00b4", "'"}, {"\u2033", "\""}, {"\u201c", "\""},
    {"\u201d", "\""}, {"\u00d7", "x"}, {"\u2715", "x"}, {"\u2013", "-"}, {"\u2014", "-"}, {"\u2212", "-"},
    {"\u2010", "-"}, {"\u00a0", " "}, {"\u202f", " "}, {"\u2009", " "}, {"\u00b2", "2"}, {"\u00b3", "3"},
    {"\u00bd", ".5"}, {"\u00bc", ".25"}, {"\u00be", ".75"}, {"\u00e9", "e"}, {"\u00e8", "e"}, {"\u00ea", "e"},
    {"\u00e1", "a"}, {"\u00e0", "a"}, {"\u00e2", "a"}, {"\u00e4", "a"}, {"\u00f6", "o"}, {"\u00f4", "o"},
    {"\u00fc", "u"}, {"\u00fb", "u"}, {"\u00ee", "i"}, {"\u00e7", "c"},
}};

std::string Plain(std::string_view text) {
  std::string plain;
  plain.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const auto byte = static_cast<unsigned char>(text[at]);
    bool replaced = false;
    if (byte >= 0x80) {
      for (const auto& [from, to] : kPlainForms) {
        if (text.compare(at, from.size(), from) != 0) continue;
        plain += to;
        at += from.size();
        replaced = true;
        break;
      }
    }
    if (replaced) continue;
    plain += byte >= 'A' && byte <= 'Z' ? static_cast<char>(byte + 32) : static_cast<char>(byte);
    ++at;
  }
  return plain;
}

bool IsSpace(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80; }

class Scanner {
 public:
  explicit Scanner(std::string text) : text_(std::move(text)) {}

  std::vector<Token> Run() {
    while (at_ < text_.size()) {
      if (IsSpace(text_[at_]) || static_cast<unsigned char>(text_[at_]) < ' ' || text_[at_] == 0x7f) {
        space_ = true;
        ++at_;
      } else if (StartsNumber()) {
        ReadNumber();
      } else if (IsLetter(text_[at_])) {
        ReadWord();
      } else {
        Add(TokenKind::kMark, text_.substr(at_, 1), 0);
        ++at_;
      }
    }
    return std::move(tokens_);
  }

 private:
  char Next(std::size_t ahead) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  bool AfterNumber() const { return !tokens_.empty() && tokens_.back().kind == TokenKind::kNumber; }

  bool AfterWord() const { return !space_ && !tokens_.empty() && tokens_.back().kind == TokenKind::kWord; }

  bool StartsNumber() const {
    const char c = text_[at_];
    if (IsDigit(c)) return true;
    if (c == '.' && IsDigit(Next(1))) return space_ || tokens_.empty() || tokens_.back().kind == TokenKind::kMark;
    const bool digits_follow = IsDigit(Next(1)) || (Next(1) == '.' && IsDigit(Next(2)));
    const bool after_x = AfterWord() && tokens_.back().Is("x");
    return c == '-' && digits_follow && !AfterNumber() && (!AfterWord() || after_x);
  }

  void ReadNumber() {
    const std::size_t begin = at_;
    if (text_[at_] == '-') ++at_;
    while (IsDigit(Next(0))) ++at_;
    std::string digits = text_.substr(begin, at_ - begin);
    if ((Next(0) == '.' || Next(0) == ',') && IsDigit(Next(1))) {
      const bool comma = Next(0) == ',';
      const std::size_t fraction = ++at_;
      while (IsDigit(Next(0))) ++at_;
      const std::string decimals = text_.substr(fraction, at_ - fraction);
      const bool thousands = comma && decimals.size() == 3 && text_.compare(SkipSpaces(), 2, "mm") == 0;
      digits += (thousands ? "" : ".") + decimals;
    }
    double value = 0;
    if (digits[0] == '.' || digits.compare(0, 2, "-.") == 0) digits.insert(digits[0] == '-' ? 1 : 0, "0");
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    Add(TokenKind::kNumber, text_.substr(begin, at_ - begin), value);
  }

  std::size_t SkipSpaces() const {
    std::size_t at = at_;
    while (at < text_.size() && IsSpace(text_[at])) ++at;
    return at;
  }

  void ReadWord() {
    const std::size_t begin = at_;
    if (text_[at_] == 'x' && (!IsLetter(Next(1)))) {  // the x of "4x5", "4 x 5"
      ++at_;
      Add(TokenKind::kWord, "x", 0);
      return;
    }
    while (IsLetter(Next(0)) || (Next(0) == '\'' && IsLetter(Next(1)))) ++at_;
    std::string word = text_.substr(begin, at_ - begin);
    // "m2", "ft2", "m^2": the exponent belongs to the unit.
    const bool unit = word == "m" || word == "ft";
    if (unit && Next(0) == '^' && Next(1) == '2') ++at_;
    if (unit && Next(0) == '2' && !IsDigit(Next(1)) && Next(1) != '.') {
      ++at_;
      word += "2";
    }
    // "4mx5m": the unit, then the sign between the sides.
    if (AfterNumber() && !space_ && word.size() > 1 && word.back() == 'x' && IsDigit(Next(0))) {
      word.pop_back();
      Add(TokenKind::kWord, word, 0);
      Add(TokenKind::kWord, "x", 0);
      return;
    }
    Add(TokenKind::kWord, std::move(word), 0);
  }

  void Add(TokenKind kind, std::string text, double value) {
    tokens_.push_back({kind, std::move(text), value, space_});
    space_ = false;
  }

  std::string text_;
  std::size_t at_ = 0;
  bool space_ = false;
  std::vector<Token> tokens_;
};

bool EndsWith(std::string_view text, std::string_view end) {
  return text.size() > end.size() && text.substr(text.size() - end.size()) == end;
}

}  // namespace

std::vector<Token> Tokenize(std::string_view text) { return Scanner(Plain(text)).Run(); }

std::vector<std::string> WordsOf(std::string_view phrase) {
  std::vector<std::string> words;
  for (Token& token : Tokenize(phrase)) {
    const bool wildcard = token.Is("*") && !token.space_before && !words.empty();
    if (wildcard) {
      words.back() += "*";
    } else if (token.kind != TokenKind::kMark) {
      words.push_back(std::move(token.text));
    } else if (token.Is("*")) {
      words.push_back("*");
    }
  }
  return words;
}

std::string SingularOf(std::string_view word) {
  std::string text(word);
  if (EndsWith(word, "shelves")) return text.substr(0, text.size() - 3) + "f";
  if (EndsWith(word, "ies") && word.size() > 4) return text.substr(0, text.size() - 3) + "y";
  for (const std::string_view end : {"ches", "shes", "xes", "sses"}) {
    if (EndsWith(word, end)) return text.substr(0, text.size() - 2);
  }
  if (EndsWith(word, "s") && !EndsWith(word, "ss") && !EndsWith(word, "us") && word.size() > 3) text.pop_back();
  return text;
}

}  // namespace flair::language
