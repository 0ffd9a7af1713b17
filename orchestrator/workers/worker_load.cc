// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/workers/worker_load.h"

#include <algorithm>
#include <cmath>

namespace flair::orchestrator {
namespace {

// Part of the newest call in the mean.
constexpr double kNewest = 0.2;
// A mean loses half of its weight in this time and this number of calls.
constexpr absl::Duration kHalfLife = absl::Seconds(1);
constexpr int kHalfLifeCalls = 10;
// How long a worker that is full is left alone: doubled as long as it stays full.
constexpr absl::Duration kFirstRest = absl::Milliseconds(20);
constexpr absl::Duration kLongestRest = absl::Seconds(2);

}  // namespace

void WorkerLoad::EndAnswered(int64_t call, absl::Duration now) {
  Learn(Remove(call, now), now);
  window_ = std::min<double>(limit_, window_ + 1.0 / window_);
  rest_ = absl::ZeroDuration();
}

void WorkerLoad::EndRefused(int64_t call, absl::Duration now) {
  Remove(call, now);
  // Calls that were under way together are refused together; that is one refusal.
  if (now < rest_end_) return;
  window_ = std::max(1.0, std::min<double>(window_, in_flight()) / 2);
  rest_ = rest_ == absl::ZeroDuration() ? kFirstRest : std::min(rest_ * 2, kLongestRest);
  rest_end_ = now + rest_;
}

absl::Duration WorkerLoad::EndOtherwise(int64_t call, absl::Duration now) {
  const absl::Duration duration = Remove(call, now);
  if (duration > mean_) Learn(duration, now);
  return duration;
}

void WorkerLoad::Forget() {
  window_ = limit_;
  mean_ = rest_ = absl::ZeroDuration();
  rest_end_ = -absl::InfiniteDuration();
}

absl::Duration WorkerLoad::Estimate(absl::Duration now, absl::Duration typical) const {
  absl::Duration estimate = typical;
  if (mean_ > absl::ZeroDuration()) {
    const absl::Duration age = std::max(now - learnt_at_, absl::ZeroDuration());
    estimate = mean_ * std::exp2(-absl::FDivDuration(age, kHalfLife + kHalfLifeCalls * mean_));
  }
  if (!in_flight_.empty()) estimate = std::max(estimate, now - in_flight_.begin()->second);
  return std::max(estimate, absl::Microseconds(1));
}

absl::Duration WorkerLoad::Remove(int64_t call, absl::Duration now) {
  const auto found = in_flight_.find(call);
  if (found == in_flight_.end()) return absl::ZeroDuration();
  const absl::Duration duration = now - found->second;
  in_flight_.erase(found);
  return duration;
}

void WorkerLoad::Learn(absl::Duration duration, absl::Duration now) {
  mean_ = mean_ == absl::ZeroDuration() ? duration : mean_ + (duration - mean_) * kNewest;
  mean_ = std::max(mean_, absl::Microseconds(1));
  learnt_at_ = now;
}

}  // namespace flair::orchestrator
