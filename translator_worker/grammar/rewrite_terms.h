// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "translator_worker/grammar/term.h"

namespace flair::translator {

// Brings forms of one meaning to one form, so that the rules need not know them all: labels before a colon go, examples
// take the place of what they are examples of, "avoid X near Y" becomes "X not near Y". Linear in the number of terms.
void RewriteTerms(std::vector<Term>& terms);

}  // namespace flair::translator
