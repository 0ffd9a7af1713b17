// SPDX-License-Identifier: GPL-3.0-or-later
// The peers of this optimizer, and which of them are worth asking now.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "flair/v1/optimizer_service.pb.h"
#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/clock/clock.h"

namespace flair::optimizer {

class PeerOptimizer {
 public:
  virtual ~PeerOptimizer() = default;
  // For logs.
  virtual const std::string& name() const = 0;
  // OptimizerService.SolveRestarts; waits for the answer, which is not checked. CANCELLED soon after `cancellation` was
  // asked for. Thread-safe.
  virtual absl::StatusOr<v1::SolveRestartsResponse> SolveRestarts(const v1::SolveRestartsRequest& request,
                                                                  runtime::Cancellation& cancellation) = 0;
};

// Thread-safe. All solves of this process share the peers: a peer has at most kMostCalls calls at a time, and who waits
// for one is served in the order of coming. A peer that fails rests for a second, then two, four ... up to a minute;
// one success ends that. Why it failed is told to `remark`, one sentence each time.
class PeerPool {
 public:
  static constexpr int kMostCalls = 2;

  // The right to one call; ends with the object.
  class Slot {
   public:
    Slot(PeerPool& pool, const PeerOptimizer& peer) : pool_(&pool), peer_(&peer) {}
    Slot(Slot&& other) noexcept : pool_(std::exchange(other.pool_, nullptr)), peer_(other.peer_) {}
    Slot& operator=(Slot&&) = delete;
    ~Slot() {
      if (pool_ != nullptr) pool_->Leave(*peer_);
    }

   private:
    PeerPool* pool_;
    const PeerOptimizer* peer_;
  };

  // `clock` must outlive the pool. `remark` is called from several threads.
  PeerPool(
      std::vector<std::unique_ptr<PeerOptimizer>> peers, const runtime::Clock& clock,
      std::function<void(const std::string&)> remark = [](const std::string&) {});

  bool empty() const { return peers_.empty(); }
  // Those that do not rest, in the order given.
  std::vector<PeerOptimizer*> Available() const;
  void ReportFailure(const PeerOptimizer& peer, const absl::Status& why);
  void ReportSuccess(const PeerOptimizer& peer);
  // Waits until `peer` may be called; nullopt once `gives_up` says so, which is asked every few milliseconds.
  std::optional<Slot> WaitForSlot(const PeerOptimizer& peer, const std::function<bool()>& gives_up);

 private:
  struct Entry {
    std::unique_ptr<PeerOptimizer> peer;
    int failures = 0;
    absl::Duration rests_until = absl::ZeroDuration();
    int calls = 0;
    // Those who wait for a call, by ticket.
    std::deque<int64_t> queue;
  };
  void Leave(const PeerOptimizer& peer);
  Entry& EntryOf(const PeerOptimizer& peer);

  const runtime::Clock& clock_;
  const std::function<void(const std::string&)> remark_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  int64_t next_ticket_ = 0;
  std::vector<Entry> peers_;
};

}  // namespace flair::optimizer
