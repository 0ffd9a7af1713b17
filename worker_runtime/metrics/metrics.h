// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/time/time.h"
#include "worker_runtime/executor/executor.h"

namespace flair::runtime {

enum class MetricKind { kCounter, kGauge, kHistogram };

// What is measured, declared once as a constant beside the code that measures it:
//   constexpr MetricFamily kRestarts = CounterFamily("flair_optimizer_restarts_total", "Restarts of the solver.");
// Names follow Prometheus: letters, digits and "_", the unit last ("_seconds", "_bytes"), counters end in "_total".
struct MetricFamily {
  MetricKind kind = MetricKind::kCounter;
  std::string_view name;
  // One sentence for people.
  std::string_view help;
  // Names of what tells apart the values, such as "rpc"; unused ones are empty and last. The values of each come from a
  // small fixed set.
  std::array<std::string_view, 2> labels = {};
  // Of histograms: upper ends of the buckets, growing.
  std::span<const double> buckets = {};

  constexpr size_t label_count() const {
    size_t count = 0;
    while (count < labels.size() && !labels[count].empty()) ++count;
    return count;
  }
};

// From half a millisecond, which a call in one machine takes, to the ten minutes that a stage may take.
inline constexpr double kSecondsBuckets[] = {0.0005, 0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1, 0.25,
                                             0.5,    1,     2.5,    5,     10,   30,    60,   180, 600};

using MetricLabels = std::array<std::string_view, 2>;
constexpr MetricFamily CounterFamily(std::string_view name, std::string_view help, MetricLabels labels = {}) {
  return {MetricKind::kCounter, name, help, labels};
}
constexpr MetricFamily GaugeFamily(std::string_view name, std::string_view help, MetricLabels labels = {}) {
  return {MetricKind::kGauge, name, help, labels};
}
constexpr MetricFamily HistogramFamily(std::string_view name, std::string_view help, std::span<const double> buckets,
                                       MetricLabels labels = {}) {
  return {MetricKind::kHistogram, name, help, labels, buckets};
}

// Of a counter, which only grows, a gauge, which goes up and down, or a histogram, which notes how often which value
// was seen: what was counted under one set of labels.
class Meter {
 public:
  explicit Meter(std::function<void(double)> add = [](double) {}) : add_(std::move(add)) {}
  // A histogram sees the value. To a counter amounts below 0 and those that are no number add nothing.
  void Add(double amount = 1) { add_(amount); }

 private:
  const std::function<void(double)> add_;
};

// A gauge, or a counter that somebody else keeps, that is asked for its value when somebody looks; until this object is
// destroyed, which waits for a look that is under way.
class WatchedValue {
 public:
  virtual ~WatchedValue() = default;
};

// One value for each of the family's labels, in order.
using LabelValues = std::initializer_list<std::string_view>;

// Where figures about the program's work go. Looking up a meter takes a lock and a search: hot code keeps what it
// found. What is returned lives as long as this object; all of it is thread-safe. Families are constants that outlive
// it.
class Metrics {
 public:
  virtual ~Metrics() = default;

  virtual Meter& Get(const MetricFamily& family, LabelValues labels = {}) = 0;

  // `read` is called from any thread, one call at a time; it must be quick and must not use Metrics.
  [[nodiscard]] virtual std::unique_ptr<WatchedValue> Watch(const MetricFamily& family, LabelValues labels,
                                                            std::function<double()> read) = 0;

  // Shows the family before it has values, so that people and alerts find it.
  virtual void Declare(const MetricFamily& family) = 0;
};

// Forgets everything. Lives for the whole process.
Metrics& NullMetrics();

// What is counted of one RPC. Thread-safe; `name` must live as long.
class RpcCounters {
 public:
  RpcCounters(Metrics& metrics, std::string_view name);

  void Begin() { in_flight_.Add(1); }
  // `total` from arrival to answer.
  void End(absl::StatusCode code, absl::Duration total);
  // A thread began to work on it, so long after its arrival.
  void ObserveWait(absl::Duration wait) { wait_.Add(absl::ToDoubleSeconds(wait)); }
  // It was turned away because too many wait.
  void Refuse() { refused_.Add(); }

 private:
  static constexpr int kCodeCount = 17;

  Metrics& metrics_;
  const std::string name_;
  Meter& in_flight_;
  Meter& duration_;
  Meter& wait_;
  Meter& refused_;
  // By code, looked up when first needed.
  std::array<std::atomic<Meter*>, kCodeCount> ended_ = {};
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
