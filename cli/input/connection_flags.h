// SPDX-License-Identifier: GPL-3.0-or-later
// How servers are reached, as a person says it: TLS, and who asks.
#pragma once

#include "CLI/CLI.hpp"
#include "absl/status/statusor.h"
#include "worker_runtime/grpc/channel.h"

namespace flair::cli {

// Adds --tls, --tls-authority, --tls-certificate and --tls-key to every command that takes the address of a server, and
// --token-file and --allow-insecure to those that take that of an orchestrator. After all commands, once: one process
// runs one command, and reaches all servers that it is told of in one way.
void AddConnectionFlags(CLI::App& program);

// As the flags and the environment say. INVALID_ARGUMENT names the flag or variable, the file and what is wrong with
// it. Stages of others are not told the token; without one, plain text goes to any machine.
absl::StatusOr<runtime::ChannelOptions> StageConnection();
absl::StatusOr<runtime::ChannelOptions> OrchestratorConnection();

}  // namespace flair::cli
