// SPDX-License-Identifier: GPL-3.0-or-later
// Strings, numbers and words of JSON as models write them when nobody holds them to its grammar.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace flair::llm {

// One of them, from the start of a text.
struct JsonWord {
  // What it says, for paths; as written.
  std::string_view content;
  // Bytes of the text, at least 1.
  size_t length = 1;
};

// Bytes of the quotation mark that the text begins with: straight, single or typographic; 0 for none.
size_t QuoteLength(std::string_view text);

// The comma or colon that a full-width one at the start of a text stands for; 0 for other texts.
char FullWidthMark(std::string_view text);

// A string. Marks that nothing of JSON follows are part of it ("a 24" screen"), as are line ends; escapes that JSON
// does not know stand for their characters, halves of characters for U+FFFD. The text begins with a mark. Appended to
// `json` as JSON has it; when the text ends in the string, without a closing quote.
JsonWord ReadQuoted(std::string_view text, std::string& json);

// A number, true, false, null, Python's words for them, or, when `quoted`, any other words up to the next mark of JSON
// as a string: keys without quotes, "1.6 m". Else those stay as they are. Appended to `json`.
JsonWord ReadBare(std::string_view text, bool quoted, std::string& json);

}  // namespace flair::llm
