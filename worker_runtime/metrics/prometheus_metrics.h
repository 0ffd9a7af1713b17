// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <prometheus/collectable.h>
#include <prometheus/registry.h>

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "worker_runtime/metrics/metrics.h"

namespace flair::runtime {

// Keeps figures for Prometheus. A family takes at most kLabelSetLimit combinations of label values; what comes after is
// counted under "other", so that no caller can fill the memory. Thread-safe.
class PrometheusMetrics final : public Metrics, public prometheus::Collectable {
 public:
  static constexpr size_t kLabelSetLimit = 500;

  PrometheusMetrics();
  ~PrometheusMetrics() override;

  Meter& Get(const MetricFamily& family, LabelValues labels) override;
  std::unique_ptr<WatchedValue> Watch(const MetricFamily& family, LabelValues labels,
                                      std::function<double()> read) override;
  void Declare(const MetricFamily& family) override;

  // All families, sorted by name; also those without values.
  std::vector<prometheus::MetricFamily> Collect() const override;

 private:
  class Watched;

  prometheus::Registry registry_;
  mutable std::mutex mutex_;
  std::map<std::string, const MetricFamily*, std::less<>> declared_;
  // Of a family, by label values.
  std::map<std::string, std::map<std::vector<std::string>, std::unique_ptr<Meter>>, std::less<>> meters_;
  // Held while they are asked. Apart from mutex_, so that counting goes on meanwhile.
  mutable std::mutex watched_mutex_;
  std::vector<const Watched*> watched_;
};

// What the running process takes of its machine, under the names that Prometheus's own libraries use, and what it is.
// Read from /proc when somebody looks; figures that it does not give are 0.
class ProcessMetrics {
 public:
  ProcessMetrics(Metrics& metrics, const std::string& program, const std::string& build);

 private:
  std::vector<std::unique_ptr<WatchedValue>> watched_;
};

// Answers GET /metrics over HTTP with the figures of the process, on one thread. Takes a few connections at a time,
// each for one request of a few kilobytes, so that no caller can take files, memory or threads from the program.
class MetricsEndpoint {
 public:
  // `address` is "HOST:PORT"; port 0 takes a free one. INVALID_ARGUMENT for an address of another form, UNAVAILABLE
  // when it cannot be bound. `metrics` outlives the endpoint. A caller has `patience` to send its request and to take
  // the answer.
  static absl::StatusOr<std::unique_ptr<MetricsEndpoint>> Start(const std::string& address,
                                                                const PrometheusMetrics& metrics,
                                                                absl::Duration patience = absl::Seconds(3));
  // Closes all connections.
  ~MetricsEndpoint();

  // Where it listens, with the port chosen, such as "127.0.0.1:43211".
  const std::string& address() const { return address_; }

 private:
  class Server;
  MetricsEndpoint(std::unique_ptr<Server> server, std::string address);

  const std::unique_ptr<Server> server_;
  const std::string address_;
};

}  // namespace flair::runtime
