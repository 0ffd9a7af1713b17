// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "absl/status/statusor.h"
#include "flair/config/v1/orchestrator_config.pb.h"
#include "flair/config/v1/runtime_config.pb.h"
#include "orchestrator/batch/work_queue.h"
#include "worker_runtime/clock/clock.h"

namespace flair::orchestrator {

// The queue and the artifacts that NATS servers with JetStream keep under `config.name`; made when they are not there
// yet. Any number of processes on any machines may open them. Once open, a connection that breaks is made again for
// ever, and calls end with UNAVAILABLE after some ten seconds without it.
//   config   whose defaults need not be filled in; INVALID_ARGUMENT names the field that is wrong ("queue.name: ...")
//   tls      the authority and our certificate, for addresses with "tls://"; null for none
//   clock    outlives what is returned
// UNAVAILABLE when no server can be reached or none has JetStream; FAILED_PRECONDITION when fewer servers than
// replica_count; UNAUTHENTICATED when they refuse the credentials.
absl::StatusOr<std::unique_ptr<WorkQueue>> OpenJetStreamQueue(const config::v1::QueueConfig& config,
                                                              const config::v1::TlsConfig* tls,
                                                              const runtime::Clock& clock);
absl::StatusOr<std::unique_ptr<ArtifactStore>> OpenJetStreamArtifacts(const config::v1::QueueConfig& config,
                                                                      const config::v1::TlsConfig* tls,
                                                                      const runtime::Clock& clock);

}  // namespace flair::orchestrator
