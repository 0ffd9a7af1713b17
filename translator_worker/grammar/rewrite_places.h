// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "translator_worker/grammar/term.h"

namespace flair::translator {

// Gives places one form: "0.6 m is kept free behind it" is space behind it, "all round the table" all its sides. Linear
// in the number of terms.
void RewritePlaces(std::vector<Term>& terms);

// What must be in place before other rewriting: "center the stand opposite the sofa" begins with the stand.
void BringPlacesFirst(std::vector<Term>& terms);

}  // namespace flair::translator
