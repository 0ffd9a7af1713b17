// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/metrics/metrics.h"

namespace flair::runtime {
namespace {

class NullMetricsImpl final : public Metrics {
 public:
  void Count(std::string_view, std::string_view, double) override {}
  void Observe(std::string_view, std::string_view, double) override {}
};

}  // namespace

Metrics& NullMetrics() {
  static NullMetricsImpl metrics;
  return metrics;
}

}  // namespace flair::runtime
