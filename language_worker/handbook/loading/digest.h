// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace flair::language {

// SHA-256 of the bytes, in lower-case hex.
std::string Sha256Hex(std::string_view bytes);

}  // namespace flair::language
