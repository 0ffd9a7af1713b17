// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/metrics/metrics.h"

namespace flair::runtime {
namespace {

class NullMetricsForm final : public Metrics {
 public:
  Meter& Get(const MetricFamily&, LabelValues) override { return meter_; }
  std::unique_ptr<WatchedValue> Watch(const MetricFamily&, LabelValues, std::function<double()>) override {
    return std::make_unique<WatchedValue>();
  }
  void Declare(const MetricFamily&) override {}

 private:
  Meter meter_;
};

constexpr MetricFamily kEnded =
    CounterFamily("flair_rpcs_total", "Calls answered, by gRPC status code.", {"rpc", "code"});
constexpr MetricFamily kInFlight =
    GaugeFamily("flair_rpcs_in_flight", "Calls waiting or being handled, open streams included.", {"rpc"});
constexpr MetricFamily kDuration = HistogramFamily(
    "flair_rpc_duration_seconds", "Time from a call's arrival to its answer.", kSecondsBuckets, {"rpc"});
constexpr MetricFamily kWait = HistogramFamily(
    "flair_rpc_wait_seconds", "Time from a call's arrival until a thread handles it.", kSecondsBuckets, {"rpc"});
constexpr MetricFamily kRefused = CounterFamily(
    "flair_rpcs_refused_total", "Calls refused because too many are waiting (RESOURCE_EXHAUSTED).", {"rpc"});
constexpr MetricFamily kQueued = GaugeFamily("flair_rpc_queue_length", "Calls waiting for a thread.");
constexpr MetricFamily kQueueLimit = GaugeFamily("flair_rpc_queue_limit", "Most calls that may wait (queue_limit).");
constexpr MetricFamily kBusy = GaugeFamily("flair_rpc_threads_busy", "Threads handling a call.");
constexpr MetricFamily kThreadLimit =
    GaugeFamily("flair_rpc_thread_limit", "Most threads that handle calls (worker_thread_count).");

}  // namespace

Metrics& NullMetrics() {
  static NullMetricsForm metrics;
  return metrics;
}

RpcCounters::RpcCounters(Metrics& metrics, std::string_view name)
    : metrics_(metrics),
      name_(name),
      in_flight_(metrics.Get(kInFlight, {name})),
      duration_(metrics.Get(kDuration, {name})),
      wait_(metrics.Get(kWait, {name})),
      refused_(metrics.Get(kRefused, {name})) {}

void RpcCounters::End(absl::StatusCode code, absl::Duration total) {
  in_flight_.Add(-1);
  duration_.Add(absl::ToDoubleSeconds(total));
  const int number = static_cast<int>(code);
  std::atomic<Meter*>& known = ended_[static_cast<size_t>(number >= 0 && number < kCodeCount ? number : 2)];
  Meter* counter = known.load(std::memory_order_acquire);
  if (counter == nullptr) {
    // Two threads that come here at once find the same counter.
    counter = &metrics_.Get(kEnded, {name_, absl::StatusCodeToString(code)});
    known.store(counter, std::memory_order_release);
  }
  counter->Add();
}

RpcMetrics::RpcMetrics(Metrics& metrics, const BoundedExecutor& executor)
    : metrics_(metrics),
      watched_{metrics.Watch(kQueued, {}, [&executor] { return executor.queued(); }),
               metrics.Watch(kQueueLimit, {}, [&executor] { return executor.queue_limit(); }),
               metrics.Watch(kBusy, {}, [&executor] { return executor.running(); }),
               metrics.Watch(kThreadLimit, {}, [&executor] { return executor.thread_limit(); })} {
  for (const MetricFamily* family : {&kEnded, &kInFlight, &kDuration, &kWait, &kRefused}) metrics_.Declare(*family);
}

RpcCounters& RpcMetrics::Of(std::string_view rpc) {
  std::lock_guard lock(mutex_);
  auto found = rpcs_.find(rpc);
  if (found == rpcs_.end()) found = rpcs_.emplace(rpc, std::make_unique<RpcCounters>(metrics_, rpc)).first;
  return *found->second;
}

}  // namespace flair::runtime
