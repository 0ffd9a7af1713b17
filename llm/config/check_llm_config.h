// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string_view>

#include "flair/config/v1/llm_config.pb.h"

namespace flair::llm {

// Told of every field that is bad: its name within the config, and a sentence with the value and what would be right.
// Never shows a value that may be a secret.
using ConfigReport = std::function<void(std::string_view field, std::string_view problem)>;

// Checks everything that can be known without asking a server: presence, ranges, what excludes each other. Does not
// read files or the environment.
void CheckLlmConfig(const config::v1::LlmConfig& config, const ConfigReport& report);

}  // namespace flair::llm
