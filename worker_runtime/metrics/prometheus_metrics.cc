// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/metrics/prometheus_metrics.h"

#include <prometheus/counter.h>
#include <prometheus/family.h>
#include <prometheus/gauge.h>
#include <prometheus/histogram.h>

#include <algorithm>
#include <utility>

namespace flair::runtime {
namespace {

prometheus::Labels ToLabels(const MetricFamily& family, const std::vector<std::string>& values) {
  prometheus::Labels labels;
  for (size_t i = 0; i < family.label_count(); ++i) labels.emplace(family.labels[i], values[i]);
  return labels;
}

// As many values as the family has labels, whatever was given.
std::vector<std::string> Values(const MetricFamily& family, LabelValues labels) {
  std::vector<std::string> values(labels.begin(), labels.end());
  values.resize(family.label_count());
  return values;
}

prometheus::MetricType ToType(MetricKind kind) {
  switch (kind) {
    case MetricKind::kGauge:
      return prometheus::MetricType::Gauge;
    case MetricKind::kHistogram:
      return prometheus::MetricType::Histogram;
    default:
      return prometheus::MetricType::Counter;
  }
}

template <typename Builder>
auto& Register(Builder builder, const MetricFamily& family, prometheus::Registry& registry) {
  return builder.Name(std::string(family.name)).Help(std::string(family.help)).Register(registry);
}

}  // namespace

class PrometheusMetrics::CounterForm final : public Counter {
 public:
  explicit CounterForm(prometheus::Counter& counter) : counter_(counter) {}
  void Add(double amount) override {
    if (amount > 0) counter_.Increment(amount);
  }

 private:
  prometheus::Counter& counter_;
};

class PrometheusMetrics::GaugeForm final : public Gauge {
 public:
  explicit GaugeForm(prometheus::Gauge& gauge) : gauge_(gauge) {}
  void Add(double amount) override { gauge_.Increment(amount); }

 private:
  prometheus::Gauge& gauge_;
};

class PrometheusMetrics::HistogramForm final : public Histogram {
 public:
  explicit HistogramForm(prometheus::Histogram& histogram) : histogram_(histogram) {}
  void Observe(double value) override { histogram_.Observe(value); }

 private:
  prometheus::Histogram& histogram_;
};

class PrometheusMetrics::Watched final : public WatchedValue {
 public:
  Watched(PrometheusMetrics& owner, const MetricFamily& family, LabelValues labels, std::function<double()> read)
      : owner_(owner), family_(family), labels_(ToLabels(family, Values(family, labels))), read_(std::move(read)) {
    std::lock_guard lock(owner_.watched_mutex_);
    owner_.watched_.push_back(this);
  }
  ~Watched() override {
    std::lock_guard lock(owner_.watched_mutex_);
    std::erase(owner_.watched_, this);
  }

  const MetricFamily& family() const { return family_; }
  prometheus::ClientMetric Read() const {
    prometheus::ClientMetric metric;
    for (const auto& [name, value] : labels_) metric.label.push_back({name, value});
    (family_.kind == MetricKind::kCounter ? metric.counter.value : metric.gauge.value) = read_();
    return metric;
  }

 private:
  PrometheusMetrics& owner_;
  const MetricFamily& family_;
  const prometheus::Labels labels_;
  const std::function<double()> read_;
};

PrometheusMetrics::PrometheusMetrics() = default;
PrometheusMetrics::~PrometheusMetrics() = default;

template <typename Form, typename Make>
Form& PrometheusMetrics::Find(Families<Form>& families, const MetricFamily& family, LabelValues labels,
                              const Make& make) {
  std::vector<std::string> values = Values(family, labels);
  std::lock_guard lock(mutex_);
  declared_.emplace(family.name, &family);
  Forms<Form>& forms = families[std::string(family.name)];
  if (forms.size() >= kLabelSetLimit && !forms.contains(values)) values.assign(values.size(), "other");
  std::unique_ptr<Form>& form = forms[values];
  if (form == nullptr) form = std::make_unique<Form>(make(ToLabels(family, values)));
  return *form;
}

Counter& PrometheusMetrics::GetCounter(const MetricFamily& family, LabelValues labels) {
  return Find(counters_, family, labels, [&](const prometheus::Labels& of) -> prometheus::Counter& {
    return Register(prometheus::BuildCounter(), family, registry_).Add(of);
  });
}

Gauge& PrometheusMetrics::GetGauge(const MetricFamily& family, LabelValues labels) {
  return Find(gauges_, family, labels, [&](const prometheus::Labels& of) -> prometheus::Gauge& {
    return Register(prometheus::BuildGauge(), family, registry_).Add(of);
  });
}

Histogram& PrometheusMetrics::GetHistogram(const MetricFamily& family, LabelValues labels) {
  return Find(histograms_, family, labels, [&](const prometheus::Labels& of) -> prometheus::Histogram& {
    return Register(prometheus::BuildHistogram(), family, registry_)
        .Add(of, prometheus::Histogram::BucketBoundaries(family.buckets.begin(), family.buckets.end()));
  });
}

std::unique_ptr<WatchedValue> PrometheusMetrics::Watch(const MetricFamily& family, LabelValues labels,
                                                       std::function<double()> read) {
  Declare(family);
  return std::make_unique<Watched>(*this, family, labels, std::move(read));
}

void PrometheusMetrics::Declare(const MetricFamily& family) {
  std::lock_guard lock(mutex_);
  declared_.emplace(family.name, &family);
}

std::vector<prometheus::MetricFamily> PrometheusMetrics::Collect() const {
  std::map<std::string, prometheus::MetricFamily, std::less<>> families;
  {
    std::lock_guard lock(mutex_);
    for (const auto& [name, family] : declared_) {
      families[name] = {.name = name, .help = std::string(family->help), .type = ToType(family->kind), .metric = {}};
    }
  }
  for (prometheus::MetricFamily& family : registry_.Collect()) families[family.name] = std::move(family);
  {
    std::lock_guard lock(watched_mutex_);
    for (const Watched* watched : watched_) {
      const auto family = families.find(watched->family().name);
      if (family != families.end()) family->second.metric.push_back(watched->Read());
    }
  }
  std::vector<prometheus::MetricFamily> result;
  for (auto& [name, family] : families) result.push_back(std::move(family));
  return result;
}

}  // namespace flair::runtime
