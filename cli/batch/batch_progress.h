// SPDX-License-Identifier: GPL-3.0-or-later
// What a person sees while a batch runs.
#pragma once

#include <cstdint>
#include <deque>
#include <string>

#include "absl/time/time.h"
#include "flair/v1/orchestrator_service.pb.h"

namespace flair::cli {

// How many things a second ended lately: over the last minute, or since the beginning.
class RecentRate {
 public:
  // `count` so far, never less than before.
  void See(absl::Time time, int64_t count);
  // 0 while too little is known.
  double PerSecond() const;

 private:
  struct Point {
    absl::Time time;
    int64_t count;
  };
  std::deque<Point> points_;
};

// How a batch stands.
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

}  // namespace flair::cli
