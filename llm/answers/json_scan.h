// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace flair::llm {

// A stretch of text that may be one JSON value, found by its brackets.
struct JsonScan {
  // How it ended: with its own closing bracket, with the text, or with a bracket that closes another kind, or
  // deeper than 64 levels.
  enum class End { kComplete, kTruncated, kBroken, kTooDeep };
  End end = End::kBroken;
  // Behind its last byte.
  size_t stop = 0;
  // The value without comments and trailing commas, with the commas that are missing, and with strings and words as
  // JSON has them (json_words).
  std::string json;
  // Where it ended, such as "objects[3].name"; empty at the root.
  std::string path;
  // When truncated: the value up to the last list element that is whole, closed; empty when there is none.
  std::string salvaged;
  // Truncated behind a whole list or object of the root object: nothing but its own bracket is missing, which
  // `salvaged` has.
  bool only_unclosed = false;
};

// Scans the bracket at `start` ('{' or '[') to its end. Linear in the text.
JsonScan ScanJson(std::string_view text, size_t start);

}  // namespace flair::llm
