// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "optimizer_worker/fanout/peer_pool.h"
#include "worker_runtime/clock/clock.h"
#include "worker_runtime/grpc/channel.h"

namespace flair::optimizer {

// Initial metadata of every answer to SolveRestarts: who computed it, in words. Peers must be equal in it, or a layout
// would depend on who took part.
inline constexpr char kProducerMetadata[] = "flair-producer";

// A peer at "HOST:PORT" (or another form that runtime::MakeChannel takes); connects on first use. A call ends after a
// minute at the latest, and is FAILED_PRECONDITION, naming both, when somebody else than `producer` answered.
// INVALID_ARGUMENT when the address has no such form. `clock` must outlive the peer.
absl::StatusOr<std::unique_ptr<PeerOptimizer>> MakeGrpcPeer(const std::string& address, const std::string& producer,
                                                            const runtime::Clock& clock,
                                                            const runtime::ChannelOptions& options = {});

}  // namespace flair::optimizer
