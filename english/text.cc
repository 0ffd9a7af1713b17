// SPDX-License-Identifier: GPL-3.0-or-later
#include "english/text.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include "english/language.h"

namespace flair::english {
namespace {

// Bytes of letters beyond ASCII count as letters; MakePlain has removed other characters.
bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80; }
bool IsDigit(char c) { return c >= '0' && c <= '9'; }

struct Typography {
  std::string_view from;
  std::string_view to;
};
constexpr std::array kTypography = std::to_array<Typography>({
    {"\u2019", "'"},          {"\u2018", "'"},         {"\u2032", "'"},   {"\u201C", "\""},   {"\u201D", "\""},
    {"\u2033", "\""},         {"\u2013", "-"},         {"\u2014", " - "}, {"\u2212", "-"},    {"\u00D7", " x "},
    {"\u00BD", ".5"},         {"\u00BC", ".25"},       {"\u00BE", ".75"}, {"\u2153", ".333"}, {"\u2154", ".667"},
    {"\u2265", " at least "}, {"\u2264", " at most "}, {"\u00B2", " 2"},  {"\u00E9", "e"},    {"\u00E8", "e"},
    {"\u00EA", "e"},          {"\u00A0", " "},         {"\u2044", "/"},   {"\u00C9", "e"},    {"\u00B0", " degrees "},
});

// Lower case, plain forms; `where[i]` is the byte of the text that plain byte i comes from.
struct Plain {
  std::string text;
  std::vector<size_t> where;

  void Add(std::string_view bytes, size_t position) {
    for (const char c : bytes) {
      text.push_back(c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c);
      where.push_back(position);
    }
  }
};

// Bytes of the character that begins at text[i]; 1 for bytes that begin none.
size_t LengthAt(std::string_view text, size_t i) {
  const auto first = static_cast<unsigned char>(text[i]);
  const size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : first >= 0xC2 ? 2 : 1;
  if (i + length > text.size()) return 1;
  for (size_t k = 1; k < length; ++k) {
    if ((static_cast<unsigned char>(text[i + k]) & 0xC0) != 0x80) return 1;
  }
  return length;
}

// Letters of the Latin, Greek, Cyrillic and later alphabets, but no punctuation, arrows, symbols or pictures.
bool IsForeignLetter(std::string_view character) {
  if (character.size() == 2) return character[0] != '\xC2' && character != "\u00F7";
  if (character.size() != 3) return false;
  const bool symbols = character >= "\u2000" && character <= "\u2BFF";
  const bool punctuation = character >= "\u3000" && character <= "\u303F";
  return !symbols && !punctuation && character < "\uE000";
}

Plain MakePlain(std::string_view text) {
  Plain plain;
  for (size_t i = 0; i < text.size();) {
    if (static_cast<unsigned char>(text[i]) < 0x80) {
      plain.Add(text[i] < 0x20 || text[i] == 0x7F ? " " : text.substr(i, 1), i);
      ++i;
      continue;
    }
    const auto* const known =
        std::ranges::find_if(kTypography, [&](const Typography& one) { return text.substr(i).starts_with(one.from); });
    const size_t length = known != kTypography.end() ? known->from.size() : LengthAt(text, i);
    const std::string_view character = text.substr(i, length);
    if (known != kTypography.end()) {
      plain.Add(known->to, i);
    } else if (IsForeignLetter(character)) {
      std::string lower(character);
      // À to Þ.
      if (lower[0] == '\xC3' && static_cast<unsigned char>(lower[1]) < 0x9F)
        lower[1] = static_cast<char>(lower[1] + 32);
      plain.Add(lower, i);
    } else {
      plain.Add(" ", i);
    }
    i += length;
  }
  plain.where.push_back(text.size());
  return plain;
}

class Tokenizer {
 public:
  explicit Tokenizer(std::string_view text) : plain_(MakePlain(text)), text_(plain_.text) {}

  std::vector<Token> Run() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (IsLetter(c)) {
        Word();
      } else if (IsDigit(c) || (c == '.' && IsDigit(Next(1)))) {
        Number();
      } else if (c == ' ') {
        ++at_;
      } else if (c == '\'') {
        Apostrophe();
      } else {
        Push(Token::Kind::kSign, std::string(1, c), at_, at_ + 1);
        ++at_;
      }
    }
    return std::move(tokens_);
  }

 private:
  char Next(size_t offset) const { return at_ + offset < text_.size() ? text_[at_ + offset] : ' '; }

  void Push(Token::Kind kind, std::string text, size_t begin, size_t end, double number = 0) {
    const bool glued = begin > 0 && text_[begin - 1] != ' ';
    tokens_.push_back({kind, std::move(text), number, {}, plain_.where[begin], plain_.where[end], glued});
  }

  void PushWords(std::string_view words, size_t begin, size_t end) {
    while (!words.empty()) {
      const size_t space = std::min(words.find(' '), words.size());
      Push(Token::Kind::kWord, std::string(words.substr(0, space)), begin, end);
      words.remove_prefix(std::min(space + 1, words.size()));
    }
  }

  void Word() {
    const size_t begin = at_;
    while (IsLetter(Next(0))) {
      ++at_;
      // "4x5", "4mx5m": an x before a digit is a word of its own.
      const std::string_view word = text_.substr(begin, at_ - begin);
      const bool after_figure = begin > 0 && IsDigit(text_[begin - 1]);
      if (after_figure && word == "x" && IsDigit(Next(0))) break;
      if (after_figure && Next(0) == 'x' && IsDigit(Next(1)) && Language::Get().FindUnit(word) != nullptr) break;
    }
    std::string word(text_.substr(begin, at_ - begin));
    // "e.g." and "i.e." are one word each.
    if (word.size() == 1 && Next(0) == '.' && IsLetter(Next(1)) && !IsLetter(Next(2))) {
      word += Next(1);
      at_ += Next(2) == '.' ? 3 : 2;
    }
    size_t end = at_;
    if (Next(0) == '\'' && IsLetter(Next(1))) {
      while (end + 1 < text_.size() && IsLetter(text_[end + 1])) ++end;
      ++end;
    }
    const std::string_view whole = text_.substr(begin, end - begin);
    const auto [meant, kept] = Language::Get().FindContraction(end > at_ ? whole : std::string_view(word));
    if (meant.empty()) {
      Push(Token::Kind::kWord, std::move(word), begin, at_);
      return;
    }
    if (kept > 0) Push(Token::Kind::kWord, std::string(whole.substr(0, kept)), begin, begin + kept);
    PushWords(meant, begin + kept, end);
    at_ = end;
  }

  void Number() {
    const size_t begin = at_;
    std::string digits;
    const auto take_digits = [&] {
      for (; IsDigit(Next(0)); ++at_) digits += Next(0);
    };
    take_digits();
    while (Next(0) == ',' && !digits.empty() && digits[0] != '0' && digits.size() < 4 && IsDigit(Next(1)) &&
           IsDigit(Next(2)) && IsDigit(Next(3)) && !IsDigit(Next(4))) {
      ++at_;
      take_digits();
    }
    if ((Next(0) == '.' || Next(0) == ',') && IsDigit(Next(1))) {
      digits += '.';
      ++at_;
      take_digits();
    }
    // More digits than any size has would only lose precision.
    constexpr size_t kMostDigits = 40;
    if (digits.size() > kMostDigits) digits.resize(kMostDigits);
    double value = std::strtod(digits.c_str(), nullptr);
    const char below = Next(1);
    if (Next(0) == '/' && (below == '2' || below == '3' || below == '4' || below == '8') && !IsDigit(Next(2)) &&
        digits.size() == 1) {
      value /= below - '0';
      digits += std::string("/") + below;
      at_ += 2;
    }
    Push(Token::Kind::kNumber, std::move(digits), begin, at_, value);
  }

  void Apostrophe() {
    const bool after_word = at_ > 0 && IsLetter(text_[at_ - 1]);
    const bool ending = after_word && Next(1) == 's' && !IsLetter(Next(2));
    const bool of_plural = after_word && text_[at_ - 1] == 's' && Next(1) == ' ';
    const bool inches = at_ > 0 && IsDigit(text_[at_ - 1]) && Next(1) == '\'';  // 9'6''
    const size_t length = ending || inches ? 2 : 1;
    if (inches) {
      Push(Token::Kind::kSign, "\"", at_, at_ + length);
    } else if (ending || of_plural) {
      Push(Token::Kind::kWord, "'s", at_, at_ + length);
    } else {
      Push(Token::Kind::kSign, "'", at_, at_ + 1);
    }
    at_ += length;
  }

  const Plain plain_;
  const std::string_view text_;
  size_t at_ = 0;
  std::vector<Token> tokens_;
};

}  // namespace

bool IsOneOf(const Token& token, std::initializer_list<std::string_view> words) {
  return std::ranges::any_of(words, [&](std::string_view word) { return token.IsWord(word); });
}

bool IsIn(std::string_view list, const Token& token) {
  return token.kind == Token::Kind::kWord && Language::Get().IsIn(list, token.text);
}

std::vector<Token> Tokenize(std::string_view text) { return Tokenizer(text).Run(); }

std::vector<Token> KeepClauseMarks(const std::vector<Token>& tokens) {
  std::vector<Token> kept;
  // "0.3m - 0.5m", "0.3 - 0.5m": a number, or one and its unit.
  const auto ends_in_figure = [&] {
    const size_t n = kept.size();
    return n > 0 && (kept[n - 1].kind == Token::Kind::kNumber || (n > 1 && kept[n - 2].kind == Token::Kind::kNumber));
  };
  for (size_t i = 0; i < tokens.size(); ++i) {
    const Token& token = tokens[i];
    if (token.kind != Token::Kind::kSign) {
      kept.push_back(token);
      continue;
    }
    const bool last = i + 1 == tokens.size();
    const bool before_number = !last && tokens[i + 1].kind == Token::Kind::kNumber;
    const bool apart = !last && !token.glued && !tokens[i + 1].glued;
    const auto keep_as = [&](Token::Kind kind, std::string text) {
      kept.push_back(token);
      kept.back().kind = kind;
      kept.back().text = std::move(text);
    };
    switch (token.text[0]) {
      case '.':
        // Inside an abbreviation ("approx. 2 m") a full stop ends nothing.
        if (!last && !tokens[i + 1].glued && !kept.empty() && tokens[i + 1].kind != Token::Kind::kSign &&
            Language::Get().IsIn("abbreviations", kept.back().text))
          break;
        kept.push_back(token);
        break;
      case '!':
      case '?':
      case ';':
        keep_as(Token::Kind::kSign, ".");
        break;
      case '-':
        // Joins words unless it stands alone (a dash) or between numbers (a range).
        if (apart) {
          keep_as(Token::Kind::kSign, before_number && ends_in_figure() ? "-" : ",");
        } else if (before_number && tokens[i + 1].glued) {
          kept.push_back(token);
        }
        break;
      case ',':
      case ':':
      case '(':
      case ')':
      case '/':
      case '~':
        kept.push_back(token);
        break;
      case '&':
        keep_as(Token::Kind::kWord, "and");
        break;
      case '\'':
      case '"':
        if (!token.glued || i == 0 || tokens[i - 1].kind != Token::Kind::kNumber) break;
        // "Bookshelf 13's back" is no length.
        if (i + 1 < tokens.size() && tokens[i + 1].glued && tokens[i + 1].text == "s") {
          keep_as(Token::Kind::kWord, "'s");
          ++i;
          break;
        }
        keep_as(Token::Kind::kWord, token.text[0] == '"' ? "inch" : "ft");
        break;
      default:
        break;
    }
  }
  return kept;
}

}  // namespace flair::english
