// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace flair::language {

// Replaces every {name} by its value; names without a value stay as they are.
std::string Fill(std::string_view text, const std::map<std::string, std::string, std::less<>>& values);

// Smooths text that was filled in: one space between words, "an" before vowels, no words said twice in a row ("oak
// oak"), no colour before or after a material that names it ("oak oiled oak"), capitals at the beginning of sentences.
std::string Polish(std::string_view text);

}  // namespace flair::language
