// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/metrics/prometheus_metrics.h"

#include <dirent.h>
#include <prometheus/counter.h>
#include <prometheus/family.h>
#include <prometheus/gauge.h>
#include <prometheus/histogram.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <sstream>
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

std::function<void(double)> Adder(const MetricFamily& family, const prometheus::Labels& labels,
                                  prometheus::Registry& registry) {
  switch (family.kind) {
    case MetricKind::kGauge:
      return [&gauge = Register(prometheus::BuildGauge(), family, registry).Add(labels)](double amount) {
        gauge.Increment(amount);
      };
    case MetricKind::kHistogram: {
      const prometheus::Histogram::BucketBoundaries buckets(family.buckets.begin(), family.buckets.end());
      auto& histogram = Register(prometheus::BuildHistogram(), family, registry).Add(labels, buckets);
      return [&histogram](double value) { histogram.Observe(value); };
    }
    default:
      return [&counter = Register(prometheus::BuildCounter(), family, registry).Add(labels)](double amount) {
        if (amount > 0) counter.Increment(amount);
      };
  }
}

}  // namespace

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

Meter& PrometheusMetrics::Get(const MetricFamily& family, LabelValues labels) {
  std::vector<std::string> values = Values(family, labels);
  std::lock_guard lock(mutex_);
  declared_.emplace(family.name, &family);
  auto& meters = meters_[std::string(family.name)];
  if (meters.size() >= kLabelSetLimit && !meters.contains(values)) values.assign(values.size(), "other");
  std::unique_ptr<Meter>& meter = meters[values];
  if (meter == nullptr) meter = std::make_unique<Meter>(Adder(family, ToLabels(family, values), registry_));
  return *meter;
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

namespace {

constexpr MetricFamily kCpu = CounterFamily("process_cpu_seconds_total", "CPU time of the process.");
constexpr MetricFamily kResident = GaugeFamily("process_resident_memory_bytes", "Memory in use.");
constexpr MetricFamily kVirtual = GaugeFamily("process_virtual_memory_bytes", "Address space in use.");
constexpr MetricFamily kOpenFiles = GaugeFamily("process_open_fds", "Open files and connections.");
constexpr MetricFamily kMaxFiles = GaugeFamily("process_max_fds", "Most open files and connections.");
constexpr MetricFamily kThreads = GaugeFamily("process_threads", "Threads.");
constexpr MetricFamily kStart = GaugeFamily("process_start_time_seconds", "Start time, in seconds since 1970.");
constexpr MetricFamily kBuild =
    GaugeFamily("flair_build_info", "Always 1; the labels name program and build.", {"program", "build"});

// The fields of /proc/self/stat after the program's name, which may hold anything; the first is field 3 of proc(5).
double StatField(size_t number) {
  std::ifstream file("/proc/self/stat");
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const size_t name_end = text.rfind(')');
  if (name_end == std::string::npos) return 0;
  std::istringstream fields(text.substr(name_end + 1));
  std::string field;
  for (size_t i = 3; i <= number; ++i) fields >> field;
  std::istringstream value(field);
  double result = 0;
  value >> result;
  return result;
}

double Seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

double CpuSeconds() {
  rusage usage = {};
  ::getrusage(RUSAGE_SELF, &usage);
  return Seconds(usage.ru_utime) + Seconds(usage.ru_stime);
}

double OpenFiles() {
  DIR* folder = ::opendir("/proc/self/fd");
  if (folder == nullptr) return 0;
  // Neither "." and ".." nor the file that this opened.
  int count = -3;
  while (::readdir(folder) != nullptr) ++count;
  ::closedir(folder);
  return count;
}

double MaxFiles() {
  rlimit limit = {};
  ::getrlimit(RLIMIT_NOFILE, &limit);
  return static_cast<double>(limit.rlim_cur);
}

// The kernel counts from its own start, whose time it gives in whole seconds.
double StartSeconds() {
  std::ifstream file("/proc/stat");
  std::string word;
  double boot_seconds = 0;
  while (file >> word) {
    if (word == "btime" && file >> boot_seconds) break;
  }
  return boot_seconds + StatField(22) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

}  // namespace

ProcessMetrics::ProcessMetrics(Metrics& metrics, const std::string& program, const std::string& build) {
  const auto watch = [&](const MetricFamily& family, std::function<double()> read) {
    watched_.push_back(metrics.Watch(family, {}, std::move(read)));
  };
  watch(kCpu, CpuSeconds);
  watch(kResident, [] { return StatField(24) * static_cast<double>(::sysconf(_SC_PAGESIZE)); });
  watch(kVirtual, [] { return StatField(23); });
  watch(kOpenFiles, OpenFiles);
  watch(kMaxFiles, MaxFiles);
  watch(kThreads, [] { return StatField(20); });
  watch(kStart, [start = StartSeconds()] { return start; });
  metrics.Get(kBuild, {program, build}).Add(1);
}

}  // namespace flair::runtime
