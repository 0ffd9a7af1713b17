// SPDX-License-Identifier: GPL-3.0-or-later
// Which stages other servers run, and what the language stage of this process reads, as a person says it.
#pragma once

#include <string>
#include <vector>

#include "absl/status/status.h"
#include "flair/config/v1/orchestrator_config.pb.h"

namespace CLI {
class App;
}

namespace flair::cli {

struct LlmFlags;

struct StageFlags {
  config::v1::StageAddresses addresses;  // an empty address: the stage runs in this process
  std::vector<std::string> handbooks;    // folders laid over the handbook of the own language stage, in this order
};

// Adds --language, --translator, --optimizer, --renderer and --handbook; `flags` must outlive the command.
void AddStageFlags(CLI::App& command, StageFlags& flags);

// INVALID_ARGUMENT when stages or handbooks are given that the orchestrator or the language stage would not use, or a
// model that none of the own stages would ask.
absl::Status CheckStageFlags(const StageFlags& flags, const std::string& orchestrator, const LlmFlags& llm);

}  // namespace flair::cli
