// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/token.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace flair::translator {
namespace {

bool IsLetter(char c) { return c >= 'a' && c <= 'z'; }
bool IsDigit(char c) { return c >= '0' && c <= '9'; }

struct Replacement {
  std::string_view from;
  std::string_view to;
};

// Each replacement is at most as long as what it replaces needs: positions are kept by a parallel table.
constexpr std::array kReplacements = {
    Replacement{"\xE2\x80\x99", "'"},
    Replacement{"\xE2\x80\x98", "'"},
    Replacement{"\xE2\x80\x9C", "\""},
    Replacement{"\xE2\x80\x9D", "\""},
    Replacement{"\xE2\x80\x93", "-"},
    Replacement{"\xE2\x80\x94", " - "},
    Replacement{"\xE2\x88\x92", "-"},
    Replacement{"\xC3\x97", " x "},
    Replacement{"\xC2\xBD", ".5"},
    Replacement{"\xC2\xBC", ".25"},
    Replacement{"\xC2\xBE", ".75"},
    Replacement{"\xE2\x89\xA5", " at least "},
    Replacement{"\xE2\x89\xA4", " at most "},
    Replacement{"\xC3\xA9", "e"},
    Replacement{"\xC3\xA8", "e"},
    Replacement{"\xC3\xAA", "e"},
    Replacement{"\xC2\xA0", " "},
    Replacement{"\xE2\x80\xB2", "'"},
    Replacement{"\xE2\x80\xB3", "\""},
};

// Lower case, plain forms; `where[i]` is the byte of the original that plain byte i comes from.
struct Plain {
  std::string text;
  std::vector<size_t> where;

  void Add(std::string_view bytes, size_t position) {
    for (char c : bytes) {
      text.push_back(c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c);
      where.push_back(position);
    }
  }
};

Plain MakePlain(std::string_view original) {
  Plain plain;
  for (size_t i = 0; i < original.size();) {
    const unsigned char c = static_cast<unsigned char>(original[i]);
    if (c < 0x80) {
      plain.Add(c < 0x20 ? " " : original.substr(i, 1), i);
      ++i;
      continue;
    }
    bool replaced = false;
    for (const Replacement& replacement : kReplacements) {
      if (original.substr(i, replacement.from.size()) != replacement.from) continue;
      plain.Add(replacement.to, i);
      i += replacement.from.size();
      replaced = true;
      break;
    }
    if (replaced) continue;
    plain.Add(" ", i);
    ++i;
    while (i < original.size() && (static_cast<unsigned char>(original[i]) & 0xC0) == 0x80) ++i;
  }
  plain.where.push_back(original.size());
  return plain;
}

class Tokenizer {
 public:
  explicit Tokenizer(std::string_view original) : plain_(MakePlain(original)), text_(plain_.text) {}

  std::vector<Token> Run() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (IsLetter(c)) {
        Word();
      } else if (IsDigit(c) || (c == '.' && IsDigit(Next(1)))) {
        Number();
      } else if (c == '\'') {
        Apostrophe();
      } else {
        Mark(c);
      }
    }
    return std::move(tokens_);
  }

 private:
  char Next(size_t offset) const { return at_ + offset < text_.size() ? text_[at_ + offset] : ' '; }

  void Push(Token::Kind kind, std::string text, size_t begin, size_t end, double number = 0) {
    tokens_.push_back({kind, std::move(text), number, {}, plain_.where[begin], plain_.where[end]});
  }

  void Word() {
    const size_t begin = at_;
    while (IsLetter(Next(0))) ++at_;
    std::string word(text_.substr(begin, at_ - begin));
    // "e.g." and "i.e." are one word each.
    if (word.size() == 1 && Next(0) == '.' && IsLetter(Next(1)) && !IsLetter(Next(2))) {
      word += Next(1);
      at_ += Next(2) == '.' ? 3 : 2;
    }
    if (word == "cannot") {
      Push(Token::Kind::kWord, "can", begin, at_);
      Push(Token::Kind::kWord, "not", begin, at_);
      return;
    }
    if (word.size() > 2 && word.back() == 'n' && Next(0) == '\'' && Next(1) == 't' && !IsLetter(Next(2))) {
      word = word == "can" ? word : word.substr(0, word.size() - 1);
      Push(Token::Kind::kWord, word, begin, at_);
      Push(Token::Kind::kWord, "not", begin, at_ + 2);
      at_ += 2;
      return;
    }
    Push(Token::Kind::kWord, std::move(word), begin, at_);
  }

  void Number() {
    const size_t begin = at_;
    while (IsDigit(Next(0))) ++at_;
    std::string digits(text_.substr(begin, at_ - begin));
    if ((Next(0) == '.' || Next(0) == ',') && IsDigit(Next(1))) {
      digits += '.';
      for (++at_; IsDigit(Next(0)); ++at_) digits += Next(0);
    }
    if (digits.size() > 40) digits.resize(40);
    double value = std::strtod(digits.c_str(), nullptr);
    if (Next(0) == '/' && IsDigit(Next(1)) && Next(1) != '0') {
      value /= Next(1) - '0';
      at_ += 2;
    }
    Push(Token::Kind::kNumber, std::move(digits), begin, at_, value);
  }

  void Apostrophe() {
    const bool after_word = !tokens_.empty() && at_ > 0 && IsLetter(text_[at_ - 1]);
    if (after_word && Next(1) == 's' && !IsLetter(Next(2)) && ShortensIs()) {
      Push(Token::Kind::kWord, "is", at_, at_ + 2);
      at_ += 2;
    } else if (after_word && Next(1) == 's' && !IsLetter(Next(2))) {
      Push(Token::Kind::kWord, "'s", at_, at_ + 2);
      at_ += 2;
    } else if (after_word && text_[at_ - 1] == 's' && Next(1) == ' ') {
      Push(Token::Kind::kWord, "'s", at_, at_ + 1);
      ++at_;
    } else if (at_ > 0 && IsDigit(text_[at_ - 1])) {
      Push(Token::Kind::kWord, "ft", at_, at_ + 1);
      ++at_;
    } else {
      ++at_;
    }
  }

  // "There's", "it's": "is", never whose it is.
  bool ShortensIs() const {
    const std::string& word = tokens_.back().text;
    return word == "there" || word == "it" || word == "that" || word == "this";
  }

  // "0.3m - 0.5m", "0.3 - 0.5m": a number, or one and its unit.
  bool EndsInLength() const {
    const size_t n = tokens_.size();
    return n > 0 &&
           (tokens_[n - 1].kind == Token::Kind::kNumber || (n > 1 && tokens_[n - 2].kind == Token::Kind::kNumber));
  }

  void Mark(char c) {
    const size_t begin = at_++;
    switch (c) {
      case '.':
        // Inside an abbreviation ("approx. 2 m") a full stop ends nothing.
        if (IsLetter(Next(1)) && Next(0) == ' ' && EndsAbbreviation()) return;
        if (Next(0) == ' ' && IsDigit(Next(1)) && EndsAbbreviation()) return;
        Push(Token::Kind::kPunctuation, ".", begin, at_);
        return;
      case '-':
        // Joins words unless it stands alone (a dash) or between numbers (a range).
        if (Next(0) == ' ' && begin > 0 && text_[begin - 1] == ' ') {
          Push(Token::Kind::kPunctuation, IsDigit(Next(1)) && EndsInLength() ? "-" : ",", begin, at_);
        } else if (IsDigit(Next(0)) || Next(0) == '.') {
          Push(Token::Kind::kPunctuation, "-", begin, at_);
        }
        return;
      case '"':
        if (begin > 0 && IsDigit(text_[begin - 1])) Push(Token::Kind::kWord, "inch", begin, at_);
        return;
      case '!':
      case '?':
      case ';':
        Push(Token::Kind::kPunctuation, ".", begin, at_);
        return;
      case ',':
      case ':':
      case '(':
      case ')':
      case '/':
      case '~':
        Push(Token::Kind::kPunctuation, std::string(1, c), begin, at_);
        return;
      case '&':
        Push(Token::Kind::kWord, "and", begin, at_);
        return;
      default:
        return;
    }
  }

  bool EndsAbbreviation() const {
    if (tokens_.empty()) return false;
    const std::string& word = tokens_.back().text;
    return word == "approx" || word == "min" || word == "max" || word == "ca" || word == "eg" || word == "ie" ||
           word == "no";
  }

  const Plain plain_;
  const std::string_view text_;
  size_t at_ = 0;
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> Tokenize(std::string_view text) { return Tokenizer(text).Run(); }

bool IsOneOf(const Token& token, std::initializer_list<std::string_view> words) {
  return std::any_of(words.begin(), words.end(), [&](std::string_view word) { return token.IsWord(word); });
}

}  // namespace flair::translator
