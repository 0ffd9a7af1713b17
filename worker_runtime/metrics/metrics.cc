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

}  // namespace flair::runtime
