// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace flair::language {

// What a piece of a brief is.
enum class TokenKind { kWord, kNumber, kMark };

// One piece of a brief.
struct Token {
  TokenKind kind = TokenKind::kMark;
  // In lower case. Words keep inner apostrophes and hyphens split; marks are one of x * ' " / - , . ; : & and others.
  std::string text;
  // Value of a number, with its sign; decimal comma and point are the same, fractions such as 1/2 are worked out.
  double value = 0;
  // White space stood before it.
  bool space_before = false;

  bool Is(std::string_view what) const { return text == what; }
};

// Splits UTF-8 text of any content into pieces. Typographic quotes, primes, dashes, the multiplication sign, superscripts
// and vulgar fractions become their plain forms; accents are dropped from Latin letters; other characters beyond ASCII are
// kept inside words byte by byte. Linear in the length of the text.
std::vector<Token> Tokenize(std::string_view text);

// The words of a phrase of the handbook, "child's bedroom" -> {"child's", "bedroom"}.
std::vector<std::string> WordsOf(std::string_view phrase);

// The singular of a word as far as spelling tells: "shelves" -> "shelf", "boxes" -> "box", "beds" -> "bed".
std::string SingularOf(std::string_view word);

}  // namespace flair::language
