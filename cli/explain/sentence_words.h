// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace flair::cli {

// "The headboard of the double bed is against a wall." of the double bed: "Its headboard is against a wall". Without
// the full stop; unchanged but for that when the sentence does not begin with the object. `names` are what the object
// is called ("nightstand 1", "first nightstand", "nightstand_1"); `others` the names of all other objects, which a
// beginning may not be cut out of: "The desk chair" is no "desk".
std::string AboutIt(std::string_view sentence, const std::vector<std::string>& names,
                    const std::vector<std::string>& others);

// First letter in upper case.
std::string Capital(std::string text);

}  // namespace flair::cli
