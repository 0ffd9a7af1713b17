// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "optimizer_worker/fanout/peer_optimizer.h"
#include "worker_runtime/clock/clock.h"

namespace flair::optimizer {

// A peer at "HOST:PORT" (or another form that runtime::MakeChannel takes); connects on first use. A call ends after a
// minute at the latest. INVALID_ARGUMENT when the address has no such form. `clock` must outlive the peer.
absl::StatusOr<std::unique_ptr<PeerOptimizer>> MakeGrpcPeer(const std::string& address, const runtime::Clock& clock);

}  // namespace flair::optimizer
