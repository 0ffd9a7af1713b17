// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/fanout/peer_pool.h"

#include <algorithm>

namespace flair::optimizer {
namespace {

constexpr absl::Duration kFirstRest = absl::Seconds(1), kLongestRest = absl::Minutes(1);
constexpr int kMostDoublings = 6;

}  // namespace

PeerPool::PeerPool(std::vector<std::unique_ptr<PeerOptimizer>> peers, const runtime::Clock& clock) : clock_(clock) {
  for (std::unique_ptr<PeerOptimizer>& peer : peers) peers_.push_back({std::move(peer), 0, absl::ZeroDuration()});
}

PeerPool::Entry& PeerPool::EntryOf(const PeerOptimizer& peer) {
  return *std::find_if(peers_.begin(), peers_.end(), [&](const Entry& entry) { return entry.peer.get() == &peer; });
}

std::vector<PeerOptimizer*> PeerPool::Available() const {
  const std::lock_guard lock(mutex_);
  std::vector<PeerOptimizer*> available;
  for (const Entry& entry : peers_) {
    if (entry.failures == 0 || entry.rests_until <= clock_.Elapsed()) available.push_back(entry.peer.get());
  }
  return available;
}

void PeerPool::ReportFailure(const PeerOptimizer& peer) {
  const std::lock_guard lock(mutex_);
  Entry& entry = EntryOf(peer);
  const int doublings = std::min(entry.failures++, kMostDoublings);
  entry.rests_until = clock_.Elapsed() + std::min(kLongestRest, kFirstRest * (1 << doublings));
}

void PeerPool::ReportSuccess(const PeerOptimizer& peer) {
  const std::lock_guard lock(mutex_);
  EntryOf(peer).failures = 0;
}

}  // namespace flair::optimizer
