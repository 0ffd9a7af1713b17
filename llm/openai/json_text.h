// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace flair::llm {

// Appends `text` as a JSON string, byte for byte as nlohmann::json writes it; what is not UTF-8 becomes U+FFFD. A
// question is some 20 KB of text, nearly all of it plain ASCII, which takes a tenth of nlohmann's time: that walks over
// the states of UTF-8 for each byte.
void AppendJsonString(std::string_view text, std::string& json);

}  // namespace flair::llm
