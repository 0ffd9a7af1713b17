// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace flair::cli {

// What a stranger wrote must not steer the terminal: control characters but line break and tab become spaces.
std::string Printable(std::string text);

}  // namespace flair::cli
