// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "absl/status/status.h"
#include "flair/config/v1/llm_config.pb.h"

namespace flair::cli {

// What one tiny question to a model told.
struct ModelFindings {
  // OK when it answered.
  absl::Status status;
  // For people: who answered, in which form, for how many tokens. Never a key.
  std::string answer;
  // What to do when it did not answer.
  std::string remedy;
};

// Asks the server of `config`, once in each form of answers until one is accepted: with a JSON schema, in JSON mode, as
// text; only in the configured one if there is one. Neither records nor replays nor caches.
ModelFindings AskModel(const config::v1::LlmConfig& config);

}  // namespace flair::cli
