// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "language_worker/handbook/reading/opening_wish.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// Reads what a brief says of doors and windows, and marks the tokens that it has used. Words that only tell where a
// piece goes ("by the window") are no wishes, but what they say of the window's own place is one: "by the window in the
// north wall". `room` are the tokens that name the kind of room, `used` those and the ones that name furniture.
void ReadOpenings(const std::vector<Token>& tokens, const std::vector<bool>& room, std::vector<bool>& used,
                  OpeningWishes& openings);

}  // namespace flair::language
