// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <initializer_list>
#include <memory>
#include <string_view>

#include "worker_runtime/metrics/metric_family.h"

namespace flair::runtime {

// Only grows.
class Counter {
 public:
  virtual ~Counter() = default;
  // Amounts below 0 and those that are no number count nothing.
  virtual void Add(double amount = 1) = 0;
};

// Goes up and down.
class Gauge {
 public:
  virtual ~Gauge() = default;
  virtual void Add(double amount) = 0;
};

// How often which value was seen.
class Histogram {
 public:
  virtual ~Histogram() = default;
  virtual void Observe(double value) = 0;
};

// A gauge, or a counter that somebody else keeps, that is asked for its value when somebody looks; until this object is
// destroyed, which waits for a look that is under way.
class WatchedValue {
 public:
  virtual ~WatchedValue() = default;
};

// One value for each of the family's labels, in order.
using LabelValues = std::initializer_list<std::string_view>;

// Where figures about the program's work go. Looking up a counter takes a lock and a search: hot code keeps what it
// found. What is returned lives as long as this object; all of it is thread-safe. Families are constants that outlive
// it.
class Metrics {
 public:
  virtual ~Metrics() = default;

  virtual Counter& GetCounter(const MetricFamily& family, LabelValues labels = {}) = 0;
  virtual Gauge& GetGauge(const MetricFamily& family, LabelValues labels = {}) = 0;
  virtual Histogram& GetHistogram(const MetricFamily& family, LabelValues labels = {}) = 0;

  // `read` is called from any thread, one call at a time; it must be quick and must not use Metrics.
  [[nodiscard]] virtual std::unique_ptr<WatchedValue> Watch(const MetricFamily& family, LabelValues labels,
                                                            std::function<double()> read) = 0;

  // Shows the family before it has values, so that people and alerts find it.
  virtual void Declare(const MetricFamily& family) = 0;
};

// Forgets everything. Lives for the whole process.
Metrics& NullMetrics();

}  // namespace flair::runtime
