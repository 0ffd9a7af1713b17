// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace flair::llm {

// A number as text, in `unit` ("m", "deg" or none): "1.2" alone or with the name of a unit behind it, "1.2 m", "120
// cm", "90°". Nothing for anything else.
std::optional<double> ReadQuantity(std::string_view text, std::string_view unit);

}  // namespace flair::llm
