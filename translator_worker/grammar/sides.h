// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "translator_worker/grammar/composer.h"

namespace flair::translator {

// The sides that a side word means for an object; "the long sides" depend on its size: front and back when it is wider
// than deep, else left and right. Where the word leaves the side open ("one long side"), the first possible one is
// taken and a note says so. Empty for an empty word.
std::vector<std::string> SidesOf(Composer& composer, const Placed& placed);

// The single side for parameters that take one; empty when none or several are named.
std::string OneSide(Composer& composer, const Placed& placed);

// "left" for "right" and so on; empty for empty.
std::string OppositeSide(const std::string& side);

}  // namespace flair::translator
