// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/metrics/process_metrics.h"

#include <dirent.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <sstream>

namespace flair::runtime {
namespace {

constexpr MetricFamily kCpu{
    .kind = MetricKind::kCounter, .name = "process_cpu_seconds_total", .help = "CPU time of the process."};
constexpr MetricFamily kResident{
    .kind = MetricKind::kGauge, .name = "process_resident_memory_bytes", .help = "Memory that the process occupies."};
constexpr MetricFamily kVirtual{.kind = MetricKind::kGauge,
                                .name = "process_virtual_memory_bytes",
                                .help = "Address space that the process has reserved."};
constexpr MetricFamily kOpenFiles{
    .kind = MetricKind::kGauge, .name = "process_open_fds", .help = "Open files and connections."};
constexpr MetricFamily kMaxFiles{
    .kind = MetricKind::kGauge, .name = "process_max_fds", .help = "Files and connections that it may have open."};
constexpr MetricFamily kThreads{.kind = MetricKind::kGauge, .name = "process_threads", .help = "Threads."};
constexpr MetricFamily kStart{.kind = MetricKind::kGauge,
                              .name = "process_start_time_seconds",
                              .help = "When the process started, in seconds since 1970."};
constexpr MetricFamily kBuild{.kind = MetricKind::kGauge,
                              .name = "flair_build_info",
                              .help = "1; the program and what it was built from are the labels.",
                              .labels = {"program", "build"}};

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
  metrics.GetGauge(kBuild, {program, build}).Add(1);
}

}  // namespace flair::runtime
