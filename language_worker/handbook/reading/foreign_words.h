// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// Whether a text has words for rooms, or small words, of another language and none of the small words of English.
bool IsForeign(const std::vector<Token>& tokens);

}  // namespace flair::language
