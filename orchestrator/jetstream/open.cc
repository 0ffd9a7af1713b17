// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/jetstream/open.h"

#include <algorithm>

#include "orchestrator/jetstream/connect_options.h"
#include "orchestrator/jetstream/jetstream_artifacts.h"
#include "orchestrator/jetstream/jetstream_work_queue.h"
#include "orchestrator/jetstream/streams.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

absl::StatusOr<std::unique_ptr<QueueParts>> Connect(const config::v1::QueueConfig& config,
                                                    const config::v1::TlsConfig* tls, const runtime::Clock& clock) {
  RETURN_IF_ERROR(CheckQueueConfig(config, tls));
  ASSIGN_OR_RETURN(std::unique_ptr<NatsConnection> connection, NatsConnection::Open(config, tls));
  return std::make_unique<QueueParts>(std::move(connection), config, clock);
}

int ReplicaCount(const config::v1::QueueConfig& config) { return std::max(1, config.replica_count()); }

}  // namespace

absl::StatusOr<std::unique_ptr<WorkQueue>> OpenJetStreamQueue(const config::v1::QueueConfig& config,
                                                              const config::v1::TlsConfig* tls,
                                                              const runtime::Clock& clock) {
  ASSIGN_OR_RETURN(std::unique_ptr<QueueParts> parts, Connect(config, tls, clock));
  RETURN_IF_ERROR(MakeQueueStreams((parts)->api, (parts)->names, ReplicaCount(config)));
  return JetStreamWorkQueue::Open(std::move(parts));
}

absl::StatusOr<std::unique_ptr<ArtifactStore>> OpenJetStreamArtifacts(const config::v1::QueueConfig& config,
                                                                      const config::v1::TlsConfig* tls,
                                                                      const runtime::Clock& clock) {
  ASSIGN_OR_RETURN(std::unique_ptr<QueueParts> parts, Connect(config, tls, clock));
  RETURN_IF_ERROR(MakeArtifactStream((parts)->api, (parts)->names, ReplicaCount(config)));
  return std::make_unique<JetStreamArtifacts>(std::move(parts));
}

}  // namespace flair::orchestrator
