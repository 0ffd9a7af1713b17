// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "flair/config/v1/llm_config.pb.h"
#include "llm/client/chat.h"

namespace flair::llm {

// The price of the exact name, else that of the longest prefix ("gpt-4o*"), else null.
const config::v1::LlmPrice* FindPrice(const std::vector<config::v1::LlmPrice>& prices, const std::string& model);

// US dollars for the tokens of one call; 0 without a price.
double CostUsd(const std::vector<config::v1::LlmPrice>& prices, const std::string& model, const Usage& usage);

}  // namespace flair::llm
