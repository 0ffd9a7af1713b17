// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "translator_worker/grammar/term.h"

namespace flair::translator {

// Gives denials one form: "X not RELATION Y", each of a choice denied, each of several relations with a "not" of its
// own. Linear in the number of terms.
void RewriteDenials(std::vector<Term>& terms);

}  // namespace flair::translator
