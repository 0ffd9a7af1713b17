// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "english/text.h"

namespace flair::translator {

// Rewrites what words of one clause leave to another, or to what everybody knows: "0.3 m from it" after "against a
// wall", "the cashier's side, i.e. the back", "without hindering anyone". Linear in the number of tokens.
void PrepareClauses(std::vector<Token>& tokens);

}  // namespace flair::translator
