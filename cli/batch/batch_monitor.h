// SPDX-License-Identifier: GPL-3.0-or-later
// What a person sees while a batch runs.
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "absl/time/time.h"
#include "cli/progress/rate_meter.h"
#include "cli/session/batch_session.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::cli {

// The progress of a batch.
struct BatchStanding {
  v1::Batch batch;
  int64_t rejected_count = 0;
  int64_t fetched_count = 0;
  // Still reading lines.
  bool submitting = false;
  double per_second = 0;
};

// "412/1000 · 41 % · 12.3/s · 0:48 left · 4 running · failed: 3 worker, 1 infeasible". On one line; `width` columns at
// most when it is not 0.
std::string StandingText(const BatchStanding& standing, size_t width = 0);

// "0:48", "2:05:10", "3 days".
std::string TimeLeftText(absl::Duration left);

// "3 worker, 1 infeasible"; empty when nothing failed.
std::string FailuresText(const v1::Batch& batch);

// "active", "paused", "cancelled".
std::string BatchStateWord(v1::BatchState state);

int64_t EndedCount(const v1::Batch& batch);

// Shows on standard error how a batch stands while it lives: on a terminal in one line that changes, elsewhere in a
// line a minute. Says so when a batch waits and nobody takes jobs. Thread-safe.
class BatchMonitor {
 public:
  struct Options {
    bool quiet = false;
    // What to do when nobody takes jobs; empty when this process does.
    std::string remedy;
    // Adds what only this process knows.
    std::function<void(BatchStanding&)> complete = [](BatchStanding&) {};
  };

  // `session` outlives it.
  BatchMonitor(BatchSession& session, std::string batch_id, Options options);
  ~BatchMonitor();

  // A line of its own, once for each text.
  void Say(const std::string& text);

 private:
  void Run();
  void Show(const v1::Batch& batch, absl::Time now);
  void WarnIfUnserved(const v1::Batch& batch, absl::Time now);
  void Print(const std::string& line);

  BatchSession& session_;
  const std::string batch_id_;
  const Options options_;
  const bool on_terminal_;
  std::mutex mutex_;
  std::string last_said_;
  bool line_shown_ = false;
  RateMeter rate_{absl::Minutes(1)};
  absl::Time next_line_;
  absl::Time next_check_;
  runtime::Cancellation end_;
  std::thread thread_;
};

}  // namespace flair::cli
