// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace flair::language {

// Replaces every {name} by its value; names without a value stay as they are.
std::string Fill(std::string_view text, const std::map<std::string, std::string, std::less<>>& values);

}  // namespace flair::language
