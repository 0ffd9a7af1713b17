// SPDX-License-Identifier: GPL-3.0-or-later
// The kind of a room that a brief does not name.
#pragma once

#include <vector>

#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// The kind that most words of the brief hint at; null when none does.
const hb::Archetype* MostHintedAt(const Handbook& handbook, const std::vector<Token>& tokens);

// The kind that most of the pieces that are named belong to, the first of them above all: of "a trestle table with two
// benches" a dining room. The fallback when they are no kind's.
const hb::Archetype& KindOfPieces(const Handbook& handbook, const std::vector<Token>& tokens);

}  // namespace flair::language
