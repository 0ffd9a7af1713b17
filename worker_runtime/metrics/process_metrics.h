// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "worker_runtime/metrics/metrics.h"

namespace flair::runtime {

// What the running process takes of its machine, under the names that Prometheus's own libraries use, and what it is.
// Read from /proc when somebody looks; figures that it does not give are 0.
class ProcessMetrics {
 public:
  ProcessMetrics(Metrics& metrics, const std::string& program, const std::string& build);

 private:
  std::vector<std::unique_ptr<WatchedValue>> watched_;
};

}  // namespace flair::runtime
