// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/time/time.h"
#include "worker_runtime/executor/bounded_executor.h"
#include "worker_runtime/metrics/metrics.h"

namespace flair::runtime {

// What is counted of one RPC. Thread-safe; `name` must live as long.
class RpcCounters {
 public:
  RpcCounters(Metrics& metrics, std::string_view name);

  void Begin() { in_flight_.Add(1); }
  // `total` from arrival to answer.
  void End(absl::StatusCode code, absl::Duration total);
  // A thread began to work on it, so long after its arrival.
  void ObserveWait(absl::Duration wait) { wait_.Observe(absl::ToDoubleSeconds(wait)); }
  // It was turned away because too many wait.
  void Refuse() { refused_.Add(); }

 private:
  static constexpr int kCodeCount = 17;

  Metrics& metrics_;
  const std::string name_;
  Gauge& in_flight_;
  Histogram& duration_;
  Histogram& wait_;
  Counter& refused_;
  // By code, looked up when first needed.
  std::array<std::atomic<Counter*>, kCodeCount> ended_ = {};
};

// Counts the calls that a server answers, by the name of the RPC, and shows its queue. The arguments outlive it.
// Thread-safe.
class RpcMetrics {
 public:
  RpcMetrics(Metrics& metrics, const BoundedExecutor& executor);

  // `rpc` is a name from our own code, never from a caller.
  RpcCounters& Of(std::string_view rpc);

  // Number of calls that gRPC is not done with: their answers may still be on their way. Shared with them, since a
  // stream may be let go of after the server has gone.
  const std::shared_ptr<std::atomic<int>>& open_calls() const { return open_calls_; }

 private:
  Metrics& metrics_;
  const std::shared_ptr<std::atomic<int>> open_calls_ = std::make_shared<std::atomic<int>>(0);
  std::mutex mutex_;
  std::map<std::string, std::unique_ptr<RpcCounters>, std::less<>> rpcs_;
  std::array<std::unique_ptr<WatchedValue>, 4> watched_;
};

}  // namespace flair::runtime
