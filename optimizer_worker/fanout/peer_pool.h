// SPDX-License-Identifier: GPL-3.0-or-later
// The peers of this optimizer, and which of them are worth asking now.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "optimizer_worker/fanout/peer_optimizer.h"
#include "worker_runtime/clock/clock.h"

namespace flair::optimizer {

// Thread-safe. A peer that fails rests for a second, then two, four ... up to a minute; one success ends that.
class PeerPool {
 public:
  // `clock` must outlive the pool.
  PeerPool(std::vector<std::unique_ptr<PeerOptimizer>> peers, const runtime::Clock& clock);

  bool empty() const { return peers_.empty(); }
  // Those that do not rest, in the order given.
  std::vector<PeerOptimizer*> Available() const;
  void ReportFailure(const PeerOptimizer& peer);
  void ReportSuccess(const PeerOptimizer& peer);

 private:
  struct Entry {
    std::unique_ptr<PeerOptimizer> peer;
    int failures = 0;
    absl::Duration rests_until = absl::ZeroDuration();
  };
  Entry& EntryOf(const PeerOptimizer& peer);

  const runtime::Clock& clock_;
  mutable std::mutex mutex_;
  std::vector<Entry> peers_;
};

}  // namespace flair::optimizer
