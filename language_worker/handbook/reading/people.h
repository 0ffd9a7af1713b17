// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// How many a room is for: "for forty readers", "seats twelve", "a family of five", "twenty students and a teacher". Marks
// the tokens that it has used; `used` ones have another meaning ("a table for eight"). Nothing when the text does not
// say.
std::optional<int> ReadPeople(const std::vector<Token>& tokens, std::vector<bool>& used);

}  // namespace flair::language
