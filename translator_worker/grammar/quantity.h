// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "translator_worker/grammar/token.h"

namespace flair::translator {

// Joins numbers, units and their qualifiers to lengths in metres: "0.6m", "60 cm", "half a metre", "2 ft", "0.3-1m",
// "at least 0.5 m", "no more than 30 cm", "a minimum distance of 0.5 m" (the noun stays), "between 0.3 m and 0.5 m".
// Sizes are dropped, since they place nothing: "1.8m x 2.8m", "0.6m wide", "(1.5m)"; "the 1.8m side" becomes the one
// word "length:1.800".
std::vector<Token> JoinQuantities(std::vector<Token> tokens);

}  // namespace flair::translator
