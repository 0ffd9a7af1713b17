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

}  // namespace flair::language
