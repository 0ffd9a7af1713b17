// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "flair/config/v1/orchestrator_config.pb.h"
#include "flair/config/v1/runtime_config.pb.h"
#include "orchestrator/batch/artifact_store.h"
#include "orchestrator/batch/work_queue.h"
#include "worker_runtime/clock/clock.h"

namespace flair::orchestrator {

// The servers of `config.address`, in its order.
std::vector<std::string> QueueServers(const config::v1::QueueConfig& config);

// The addresses without the user, password or token that they may hold: for people and files.
std::string ShownAddress(const config::v1::QueueConfig& config);

// INVALID_ARGUMENT names the field that is wrong. `tls` is null when the program has no certificates.
absl::Status CheckQueueConfig(const config::v1::QueueConfig& config, const config::v1::TlsConfig* tls);

// How a queue and its artifacts on NATS servers are opened; see orchestrator/jetstream/open.h.
struct NatsForms {
  absl::StatusOr<std::unique_ptr<WorkQueue>> (*open_queue)(const config::v1::QueueConfig&, const config::v1::TlsConfig*,
                                                           const runtime::Clock&);
  absl::StatusOr<std::unique_ptr<ArtifactStore>> (*open_artifacts)(const config::v1::QueueConfig&,
                                                                   const config::v1::TlsConfig*, const runtime::Clock&);
};

// Called at a program's start. Without it, Nats() gives functions that return UNIMPLEMENTED, and the program links no
// NATS client: flair-design, which is built first, does without.
void UseNats(const NatsForms& forms);
const NatsForms& Nats();

}  // namespace flair::orchestrator
