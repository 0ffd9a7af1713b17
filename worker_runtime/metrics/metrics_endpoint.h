// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "worker_runtime/metrics/prometheus_metrics.h"

namespace flair::runtime {

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
