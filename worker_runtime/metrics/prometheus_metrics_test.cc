// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/metrics/prometheus_metrics.h"

#include <gmock/gmock.h>
#include <prometheus/text_serializer.h>

#include <atomic>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "worker_runtime/metrics/metrics.h"

namespace flair::runtime {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr MetricFamily kTests = CounterFamily("flair_tests_total", "Tests run.", {"outcome"});
constexpr MetricFamily kOpen = GaugeFamily("flair_tests_open", "Tests that run.");
constexpr double kBuckets[] = {0.1, 1};
constexpr MetricFamily kDuration = HistogramFamily("flair_test_duration_seconds", "What tests take.", kBuckets);

std::string Text(const PrometheusMetrics& metrics) { return prometheus::TextSerializer().Serialize(metrics.Collect()); }

TEST(PrometheusMetrics, ShowsWhatWasCountedUnderItsLabels) {
  PrometheusMetrics metrics;
  metrics.Get(kTests, {"passed"}).Add();
  metrics.Get(kTests, {"passed"}).Add(2);
  metrics.Get(kTests, {"failed"}).Add();
  metrics.Get(kDuration, {}).Add(0.5);
  const std::string text = Text(metrics);
  EXPECT_THAT(text, HasSubstr("# HELP flair_tests_total Tests run.\n# TYPE flair_tests_total counter\n"));
  EXPECT_THAT(text, HasSubstr("flair_tests_total{outcome=\"passed\"} 3"));
  EXPECT_THAT(text, HasSubstr("flair_tests_total{outcome=\"failed\"} 1"));
  EXPECT_THAT(text, HasSubstr("flair_test_duration_seconds_bucket{le=\"0.1\"} 0"));
  EXPECT_THAT(text, HasSubstr("flair_test_duration_seconds_bucket{le=\"1\"} 1"));
  EXPECT_THAT(text, HasSubstr("flair_test_duration_seconds_count 1"));
}

TEST(PrometheusMetrics, ACounterNeverFalls) {
  PrometheusMetrics metrics;
  Meter& counter = metrics.Get(kTests, {"passed"});
  counter.Add(2);
  counter.Add(-1);
  counter.Add(std::numeric_limits<double>::quiet_NaN());
  EXPECT_THAT(Text(metrics), HasSubstr("flair_tests_total{outcome=\"passed\"} 2"));
}

TEST(PrometheusMetrics, AsksWatchedGaugesWhenSomebodyLooksAndNotAfterTheirEnd) {
  PrometheusMetrics metrics;
  int open = 1;
  auto watched = metrics.Watch(kOpen, {}, [&open] { return open; });
  EXPECT_THAT(Text(metrics), HasSubstr("\nflair_tests_open 1\n"));
  open = 7;
  EXPECT_THAT(Text(metrics), HasSubstr("\nflair_tests_open 7\n"));
  watched.reset();
  EXPECT_THAT(Text(metrics), Not(HasSubstr("\nflair_tests_open ")));
}

TEST(PrometheusMetrics, ShowsDeclaredFamiliesWithoutValues) {
  PrometheusMetrics metrics;
  metrics.Declare(kTests);
  EXPECT_EQ(Text(metrics), "# HELP flair_tests_total Tests run.\n# TYPE flair_tests_total counter\n");
}

TEST(PrometheusMetrics, LabelsWithoutEndAreCountedAsOther) {
  PrometheusMetrics metrics;
  for (size_t i = 0; i < PrometheusMetrics::kLabelSetLimit + 100; ++i) {
    metrics.Get(kTests, {std::to_string(i)}).Add();
  }
  EXPECT_THAT(Text(metrics), HasSubstr("flair_tests_total{outcome=\"other\"} 100"));
  EXPECT_EQ(metrics.Collect().front().metric.size(), PrometheusMetrics::kLabelSetLimit + 1);
}

TEST(PrometheusMetrics, EscapesWhatLabelsHold) {
  PrometheusMetrics metrics;
  metrics.Get(kTests, {"a\"b\nforged 1"}).Add();
  EXPECT_THAT(Text(metrics), HasSubstr("outcome=\"a\\\"b\\nforged 1\"} 1"));
}

TEST(PrometheusMetrics, LosesNothingWhenManyThreadsCountWhileOthersLook) {
  PrometheusMetrics metrics;
  std::atomic<bool> done = false;
  std::thread looker([&] {
    while (!done) Text(metrics);
  });
  std::vector<std::thread> counters;
  for (int t = 0; t < 4; ++t) {
    counters.emplace_back([&] {
      for (int i = 0; i < 1000; ++i) {
        metrics.Get(kTests, {i % 2 == 0 ? "passed" : "failed"}).Add();
        metrics.Get(kDuration, {}).Add(i);
        const auto watched = metrics.Watch(kOpen, {}, [] { return 1.0; });
      }
    });
  }
  for (std::thread& thread : counters) thread.join();
  done = true;
  looker.join();
  const std::string text = Text(metrics);
  EXPECT_THAT(text, HasSubstr("flair_tests_total{outcome=\"passed\"} 2000"));
  EXPECT_THAT(text, HasSubstr("flair_test_duration_seconds_count 4000"));
}

TEST(RpcMetrics, CountsCallsByNameAndCode) {
  PrometheusMetrics metrics;
  BoundedExecutor executor(3, 5);
  RpcMetrics rpcs(metrics, executor);
  RpcCounters& solve = rpcs.Of("Solve");
  EXPECT_EQ(&solve, &rpcs.Of("Solve"));
  solve.Begin();
  solve.Begin();
  solve.Begin();
  solve.ObserveWait(absl::Milliseconds(2));
  solve.End(absl::StatusCode::kOk, absl::Milliseconds(20));
  solve.End(absl::StatusCode::kResourceExhausted, absl::ZeroDuration());
  const std::string text = Text(metrics);
  EXPECT_THAT(text, HasSubstr("flair_rpcs_total{code=\"OK\",rpc=\"Solve\"} 1"));
  EXPECT_THAT(text, HasSubstr("flair_rpcs_total{code=\"RESOURCE_EXHAUSTED\",rpc=\"Solve\"} 1"));
  EXPECT_THAT(text, HasSubstr("flair_rpcs_in_flight{rpc=\"Solve\"} 1"));
  EXPECT_THAT(text, HasSubstr("flair_rpc_wait_seconds_count{rpc=\"Solve\"} 1"));
  EXPECT_THAT(text, HasSubstr("flair_rpc_duration_seconds_bucket{rpc=\"Solve\",le=\"0.025\"} 2"));
  EXPECT_THAT(text, HasSubstr("\nflair_rpc_queue_limit 5\n"));
  EXPECT_THAT(text, HasSubstr("\nflair_rpc_thread_limit 3\n"));
}

}  // namespace
}  // namespace flair::runtime
