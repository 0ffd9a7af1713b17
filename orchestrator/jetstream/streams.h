// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/status.h"
#include "orchestrator/jetstream/api.h"
#include "orchestrator/jetstream/names.h"

namespace flair::orchestrator {

// Makes the streams and buckets of a queue, or of its artifacts, that are not there. Those that are stay as they are.
absl::Status MakeQueueStreams(JetStreamApi& api, const QueueNames& names, int replica_count);
absl::Status MakeArtifactStream(JetStreamApi& api, const QueueNames& names, int replica_count);

// How long a status is known after it was reported.
inline constexpr absl::Duration kStatusLife = absl::Seconds(10);

}  // namespace flair::orchestrator
