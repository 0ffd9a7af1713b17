// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <prometheus/collectable.h>
#include <prometheus/registry.h>

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "worker_runtime/metrics/metrics.h"

namespace flair::runtime {

// Keeps figures for Prometheus. A family takes at most kLabelSetLimit combinations of label values; what comes after is
// counted under "other", so that no caller can fill the memory. Thread-safe.
class PrometheusMetrics final : public Metrics, public prometheus::Collectable {
 public:
  static constexpr size_t kLabelSetLimit = 500;

  PrometheusMetrics();
  ~PrometheusMetrics() override;

  Counter& GetCounter(const MetricFamily& family, LabelValues labels) override;
  Gauge& GetGauge(const MetricFamily& family, LabelValues labels) override;
  Histogram& GetHistogram(const MetricFamily& family, LabelValues labels) override;
  std::unique_ptr<WatchedValue> Watch(const MetricFamily& family, LabelValues labels,
                                      std::function<double()> read) override;
  void Declare(const MetricFamily& family) override;

  // All families, sorted by name; also those without values.
  std::vector<prometheus::MetricFamily> Collect() const override;

 private:
  class CounterForm;
  class GaugeForm;
  class HistogramForm;
  class Watched;
  // Of one family, by label values.
  template <typename Form>
  using Forms = std::map<std::vector<std::string>, std::unique_ptr<Form>>;
  template <typename Form>
  using Families = std::map<std::string, Forms<Form>, std::less<>>;

  template <typename Form, typename Make>
  Form& Find(Families<Form>& families, const MetricFamily& family, LabelValues labels, const Make& make);

  prometheus::Registry registry_;
  mutable std::mutex mutex_;
  std::map<std::string, const MetricFamily*, std::less<>> declared_;
  Families<CounterForm> counters_;
  Families<GaugeForm> gauges_;
  Families<HistogramForm> histograms_;
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

}  // namespace flair::runtime
