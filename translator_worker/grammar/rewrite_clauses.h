// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "translator_worker/grammar/term.h"

namespace flair::translator {

// Writes out what a clause leaves to the one before it: what "which" stands for, the figure of two places, the place
// of a space, what a passive is said of. Linear in the number of terms.
void RewriteClauses(std::vector<Term>& terms);

// "1 m in front of and behind the counter", once both have the counter: the figure is for both.
void ShareFigure(std::vector<Term>& terms);

}  // namespace flair::translator
