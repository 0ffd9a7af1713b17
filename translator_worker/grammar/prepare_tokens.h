// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "english/text.h"

namespace flair::translator {

// Makes some ways of saying a thing one, before phrases are looked up: adverbs that place nothing are dropped, "neither
// X nor Y" becomes "neither X and Y", "one accessible side" becomes "one side accessible", "there is room to sit" is
// space. Linear in the tokens.
std::vector<Token> PrepareTokens(std::vector<Token> tokens);

// Whether tokens[at] is the "to" of a reason: "0.9 m from the table to allow chairs to pull out" is not "from the table
// to the chairs".
bool BeginsReason(const std::vector<Token>& tokens, size_t at);

}  // namespace flair::translator
