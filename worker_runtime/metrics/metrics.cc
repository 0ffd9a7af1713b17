// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/metrics/metrics.h"

namespace flair::runtime {

namespace {

class NullCounter final : public Counter {
  void Add(double) override {}
};
class NullGauge final : public Gauge {
  void Add(double) override {}
};
class NullHistogram final : public Histogram {
  void Observe(double) override {}
};

class NullMetricsForm final : public Metrics {
 public:
  Counter& GetCounter(const MetricFamily&, LabelValues) override { return counter_; }
  Gauge& GetGauge(const MetricFamily&, LabelValues) override { return gauge_; }
  Histogram& GetHistogram(const MetricFamily&, LabelValues) override { return histogram_; }
  std::unique_ptr<WatchedValue> Watch(const MetricFamily&, LabelValues, std::function<double()>) override {
    return std::make_unique<WatchedValue>();
  }
  void Declare(const MetricFamily&) override {}

 private:
  NullCounter counter_;
  NullGauge gauge_;
  NullHistogram histogram_;
};

}  // namespace

Metrics& NullMetrics() {
  static NullMetricsForm metrics;
  return metrics;
}

namespace {

constexpr MetricFamily kEnded{.kind = MetricKind::kCounter,
                              .name = "flair_rpcs_total",
                              .help = "Calls answered, by gRPC status code.",
                              .labels = {"rpc", "code"}};
constexpr MetricFamily kInFlight{.kind = MetricKind::kGauge,
                                 .name = "flair_rpcs_in_flight",
                                 .help = "Calls waiting or being handled, open streams included.",
                                 .labels = {"rpc"}};
constexpr MetricFamily kDuration{.kind = MetricKind::kHistogram,
                                 .name = "flair_rpc_duration_seconds",
                                 .help = "Time from a call's arrival to its answer.",
                                 .labels = {"rpc"},
                                 .buckets = kSecondsBuckets};
constexpr MetricFamily kWait{.kind = MetricKind::kHistogram,
                             .name = "flair_rpc_wait_seconds",
                             .help = "Time from a call's arrival until a thread handles it.",
                             .labels = {"rpc"},
                             .buckets = kSecondsBuckets};
constexpr MetricFamily kRefused{.kind = MetricKind::kCounter,
                                .name = "flair_rpcs_refused_total",
                                .help = "Calls refused because too many are waiting (RESOURCE_EXHAUSTED).",
                                .labels = {"rpc"}};
constexpr MetricFamily kQueued{
    .kind = MetricKind::kGauge, .name = "flair_rpc_queue_length", .help = "Calls waiting for a thread."};
constexpr MetricFamily kQueueLimit{
    .kind = MetricKind::kGauge, .name = "flair_rpc_queue_limit", .help = "Most calls that may wait (queue_limit)."};
constexpr MetricFamily kBusy{
    .kind = MetricKind::kGauge, .name = "flair_rpc_threads_busy", .help = "Threads handling a call."};
constexpr MetricFamily kThreadLimit{.kind = MetricKind::kGauge,
                                    .name = "flair_rpc_thread_limit",
                                    .help = "Most threads that handle calls (worker_thread_count)."};

}  // namespace

RpcCounters::RpcCounters(Metrics& metrics, std::string_view name)
    : metrics_(metrics),
      name_(name),
      in_flight_(metrics.GetGauge(kInFlight, {name})),
      duration_(metrics.GetHistogram(kDuration, {name})),
      wait_(metrics.GetHistogram(kWait, {name})),
      refused_(metrics.GetCounter(kRefused, {name})) {}

void RpcCounters::End(absl::StatusCode code, absl::Duration total) {
  in_flight_.Add(-1);
  duration_.Observe(absl::ToDoubleSeconds(total));
  const int number = static_cast<int>(code);
  std::atomic<Counter*>& known = ended_[static_cast<size_t>(number >= 0 && number < kCodeCount ? number : 2)];
  Counter* counter = known.load(std::memory_order_acquire);
  if (counter == nullptr) {
    // Two threads that come here at once find the same counter.
    counter = &metrics_.GetCounter(kEnded, {name_, absl::StatusCodeToString(code)});
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
  if (found == rpcs_.end()) {
    found = rpcs_.emplace(rpc, std::make_unique<RpcCounters>(metrics_, rpc)).first;
  }
  return *found->second;
}

}  // namespace flair::runtime
