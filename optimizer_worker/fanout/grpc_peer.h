// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "flair/v1/provenance.pb.h"
#include "optimizer_worker/fanout/peer_optimizer.h"
#include "worker_runtime/clock/clock.h"

namespace flair::optimizer {

// Initial metadata of every answer to SolveRestarts: who computed it (ProducerText). Peers must be equal in it, or a
// layout would depend on who took part.
inline constexpr char kProducerMetadata[] = "flair-producer";

// "program method version".
std::string ProducerText(const v1::Producer& producer);

// A peer at "HOST:PORT" (or another form that runtime::MakeChannel takes); connects on first use. A call ends after a
// minute at the latest, and is FAILED_PRECONDITION when another producer than `producer` answered. INVALID_ARGUMENT
// when the address has no such form. `clock` must outlive the peer.
absl::StatusOr<std::unique_ptr<PeerOptimizer>> MakeGrpcPeer(const std::string& address, const v1::Producer& producer,
                                                            const runtime::Clock& clock);

}  // namespace flair::optimizer
