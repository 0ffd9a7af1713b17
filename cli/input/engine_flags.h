// SPDX-License-Identifier: GPL-3.0-or-later
// Where jobs wait, as a person says it.
#pragma once

#include <string>

#include "CLI/CLI.hpp"
#include "absl/status/status.h"
#include "flair/config/v1/orchestrator_config.pb.h"

namespace flair::cli {

// A queue in NATS JetStream; in the local store when `address` is empty.
struct EngineFlags {
  std::string address;
  std::string queue;
  std::string artifacts;
  int replica_count = 0;
};

// Adds --engine, --queue, --artifacts and --replicas; `flags` must outlive the command.
void AddEngineFlags(CLI::App& command, EngineFlags& flags);

// INVALID_ARGUMENT when the engine is given beside the orchestrator that would have to use it, or no engine beside what
// belongs to one.
absl::Status CheckEngineFlags(const EngineFlags& flags, const std::string& orchestrator);

// Tells an orchestrator of this process.
void SetEngine(const EngineFlags& flags, config::v1::OrchestratorConfig& config);

}  // namespace flair::cli
