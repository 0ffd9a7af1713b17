// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/fanout/peer_pool.h"

#include <algorithm>
#include <chrono>

#include "fmt/format.h"

namespace flair::optimizer {

namespace {

constexpr absl::Duration kFirstRest = absl::Seconds(1), kLongestRest = absl::Minutes(1);
constexpr int kMostDoublings = 6;
// How often one who waits looks whether it still wants to.
constexpr std::chrono::milliseconds kPeerGlance(5);

}  // namespace

PeerPool::PeerPool(std::vector<std::unique_ptr<PeerOptimizer>> peers, const runtime::Clock& clock,
                   std::function<void(const std::string&)> remark)
    : clock_(clock), remark_(std::move(remark)) {
  for (std::unique_ptr<PeerOptimizer>& peer : peers) peers_.emplace_back().peer = std::move(peer);
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

void PeerPool::ReportFailure(const PeerOptimizer& peer, const absl::Status& why) {
  absl::Duration rest;
  {
    const std::lock_guard lock(mutex_);
    Entry& entry = EntryOf(peer);
    const int doublings = std::min(entry.failures++, kMostDoublings);
    rest = std::min(kLongestRest, kFirstRest * (1 << doublings));
    entry.rests_until = clock_.Elapsed() + rest;
  }
  remark_(fmt::format("peer {} is left out for {} s: {}; its restarts run elsewhere", peer.name(),
                      absl::ToInt64Seconds(rest), std::string(why.message())));
}

void PeerPool::ReportSuccess(const PeerOptimizer& peer) {
  const std::lock_guard lock(mutex_);
  EntryOf(peer).failures = 0;
}

std::optional<PeerPool::Slot> PeerPool::WaitForSlot(const PeerOptimizer& peer, const std::function<bool()>& gives_up) {
  std::unique_lock lock(mutex_);
  Entry& entry = EntryOf(peer);
  const int64_t ticket = next_ticket_++;
  entry.queue.push_back(ticket);
  bool mine = false, tired = false;
  while (!mine && !tired) {
    mine = entry.queue.front() == ticket && entry.calls < kMostCalls;
    if (mine) break;
    changed_.wait_for(lock, kPeerGlance);
    lock.unlock();
    tired = gives_up();
    lock.lock();
  }
  entry.queue.erase(std::find(entry.queue.begin(), entry.queue.end(), ticket));
  if (mine) ++entry.calls;
  lock.unlock();
  changed_.notify_all();
  if (!mine) return std::nullopt;
  return std::optional<Slot>(std::in_place, *this, peer);
}

void PeerPool::Leave(const PeerOptimizer& peer) {
  {
    const std::lock_guard lock(mutex_);
    --EntryOf(peer).calls;
  }
  changed_.notify_all();
}

}  // namespace flair::optimizer
