// SPDX-License-Identifier: GPL-3.0-or-later
// What a brief says that nobody understood, so that it can be told.
#pragma once

#include <string>
#include <vector>

#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// Whether at least one word is of the kind that no longer English sentence is without ("the", "with", "and" ...). Short
// texts pass: names of rooms and sizes are alike in many languages.
bool ReadsAsEnglish(const std::vector<Token>& tokens);

// Things that the text lists with an article or a number ("with a counter, two ovens") and of whose words none is
// `used`, as many tokens as `tokens`; in its order, eight at most. What is listed without either is found when its last
// word is one for things ("vending machine"); else it may be an adjective.
std::vector<std::string> UnknownThings(const std::vector<Token>& tokens, const std::vector<bool>& used);

}  // namespace flair::language
