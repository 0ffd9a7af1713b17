// SPDX-License-Identifier: GPL-3.0-or-later
// Which stages servers of others run, as a person says it.
#pragma once

#include <string>

#include "CLI/CLI.hpp"
#include "absl/status/status.h"
#include "cli/input/llm_flags.h"
#include "flair/config/v1/orchestrator_config.pb.h"

namespace flair::cli {

// Empty addresses: stages in this process.
using StageFlags = config::v1::StageAddresses;

// Adds --language, --translator, --optimizer and --renderer; `flags` must outlive the command.
void AddStageFlags(CLI::App& command, StageFlags& flags);

// INVALID_ARGUMENT when stages are given beside the orchestrator that would have to ask them, or a model that none of
// the own stages would ask.
absl::Status CheckStageFlags(const StageFlags& flags, const std::string& orchestrator, const LlmFlags& llm);

}  // namespace flair::cli
