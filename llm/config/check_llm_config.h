// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "flair/config/v1/llm_config.pb.h"
#include "llm/client/llm_client.h"

namespace flair::llm {

// Told of every field that is bad: its name within the config, and a sentence with the value and what would be right.
// Never shows a value that may be a secret.
using ConfigReport = std::function<void(std::string_view field, std::string_view problem)>;

// Checks everything that can be known without asking a server: presence, ranges, what excludes each other. Does not
// read files or the environment.
void CheckLlmConfig(const config::v1::LlmConfig& config, const ConfigReport& report);

// The price of the exact name, else that of the longest prefix ("gpt-4o*"), else null.
const config::v1::LlmPrice* FindPrice(const std::vector<config::v1::LlmPrice>& prices, const std::string& model);

// US dollars for the tokens of one call; 0 without a price.
double CostUsd(const std::vector<config::v1::LlmPrice>& prices, const std::string& model, const Usage& usage);

}  // namespace flair::llm
