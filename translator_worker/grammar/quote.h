// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace flair::translator {

// A sentence as messages show it: control characters as spaces, at most 160 bytes, cut between characters.
inline std::string Quote(std::string_view text) {
  constexpr size_t kLongest = 160;
  size_t length = text.size();
  if (length > kLongest) {
    length = kLongest;
    while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80) --length;
  }
  std::string result;
  for (const char c : text.substr(0, length))
    result.push_back(static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? ' ' : c);
  return length < text.size() ? result + "..." : result;
}

}  // namespace flair::translator
