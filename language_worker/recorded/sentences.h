// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace flair::language {

// The sentences of a line, none empty: it ends where a point, an exclamation or question mark is followed by a capital
// letter, not within parentheses and not in "e.g. ". Each at most 390 bytes, cut at a character's start.
std::vector<std::string> SplitSentences(std::string_view line);

// Share of the words of the shorter of both texts that the longer one has too, [0, 1]; 0 for texts without words.
double Likeness(std::string_view a, std::string_view b);

// Whether a text has nothing but a size: "0.3m x 0.3m (each)", "Width: 0.2m, Length: 0.2m.", or no words at all.
bool IsSize(std::string_view text);

// Whether it has a length in metres: "0.4m".
bool HasSize(std::string_view text);

}  // namespace flair::language
