// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace flair::llm {

// The text with U+FFFD for every byte that is no UTF-8.
std::string ToUtf8(std::string_view text);

// Good UTF-8 cut to at most `most` bytes at a character's start.
std::string CutCharacters(std::string_view text, size_t most);

// The same, with " …" behind it when it was longer.
std::string CutBytes(const std::string& text, size_t most);

// Good UTF-8 with spaces and line ends of all kinds as ASCII's, and without characters that nobody sees: byte order
// marks, soft hyphens, marks of direction. What joins letters stays.
std::string PlainSpaces(std::string text);

// With spaces in the place of control characters, but for those of `kept`.
std::string WithoutControls(std::string text, std::string_view kept = {});

}  // namespace flair::llm
