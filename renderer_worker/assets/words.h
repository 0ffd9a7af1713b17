// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace flair::renderer {

// The words of a text: letters and digits (all bytes beyond ASCII count as letters), lower case in ASCII, without words
// that tell nothing ("the", "with") and without a plural's s. At most 64, each at most 40 bytes.
std::vector<std::string> WordsOf(std::string_view text);

}  // namespace flair::renderer
