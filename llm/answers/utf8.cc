// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/utf8.h"

#include <algorithm>

namespace flair::llm {
namespace {

// Bytes of the UTF-8 character that starts at `at`; 0 when none does.
size_t CharacterAt(std::string_view text, size_t at) {
  const auto byte = [&](size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0; };
  const auto follows = [&](size_t i) { return (byte(i) & 0xC0) == 0x80; };
  const unsigned char lead = byte(at);
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead < 0xE0) return follows(at + 1) ? 2 : 0;
  if (lead >= 0xE0 && lead < 0xF0) {
    // Overlong forms and surrogates are none.
    if ((lead == 0xE0 && byte(at + 1) < 0xA0) || (lead == 0xED && byte(at + 1) > 0x9F)) return 0;
    return follows(at + 1) && follows(at + 2) ? 3 : 0;
  }
  if (lead < 0xF0 || lead > 0xF4) return 0;
  if ((lead == 0xF0 && byte(at + 1) < 0x90) || (lead == 0xF4 && byte(at + 1) > 0x8F)) return 0;
  return follows(at + 1) && follows(at + 2) && follows(at + 3) ? 4 : 0;
}

}  // namespace

std::string ToUtf8(std::string_view text) {
  std::string good;
  for (size_t i = 0; i < text.size();) {
    const size_t length = CharacterAt(text, i);
    good += length == 0 ? std::string_view("\xEF\xBF\xBD") : text.substr(i, length);
    i += std::max<size_t>(length, 1);
  }
  return good;
}

std::string CutCharacters(std::string_view text, size_t most) {
  if (text.size() <= most) return std::string(text);
  size_t end = most;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return std::string(text.substr(0, end));
}

std::string CutBytes(const std::string& text, size_t most) {
  return text.size() <= most ? text : CutCharacters(text, most) + " …";
}

}  // namespace flair::llm
