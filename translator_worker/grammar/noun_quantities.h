// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "translator_worker/grammar/noun_phrases.h"

namespace flair::translator {

// Gives "each chair", "the second nightstand" and "the other" their numbers; unknown adjectives before a thing belong
// to it, and denied things ("no chair") are followed by "not".
std::vector<RawTerm> AttachQuantities(std::vector<RawTerm> raws);

}  // namespace flair::translator
