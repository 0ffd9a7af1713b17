// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "language_worker/handbook/reading/opening_wish.h"

namespace flair::language {

inline constexpr std::string_view kCompassWords = "north northern south southern east eastern west western";

// Takes what one word before a door or window says of it: "large", "sliding", "bay", "north". `wish.door` must be set.
void Describe(std::string_view word, OpeningWish& wish);

}  // namespace flair::language
