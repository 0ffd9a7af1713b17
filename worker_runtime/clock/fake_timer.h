// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include "worker_runtime/clock/fake_clock.h"
#include "worker_runtime/clock/timer.h"

namespace flair::runtime {

// A timer on a fake clock: nothing runs until a test moves the time. Thread-safe; callbacks run in the thread of the
// test.
class FakeTimer final : public Timer {
 public:
  explicit FakeTimer(FakeClock& clock) : clock_(clock) {}

  Id RunAfter(absl::Duration delay, TimerCallback callback) override {
    const std::lock_guard lock(mutex_);
    delays_.push_back(delay);
    waiting_.emplace(std::pair(clock_.Elapsed() + delay, next_id_), std::move(callback));
    return next_id_++;
  }

  void Hasten(Id id) override {
    const std::lock_guard lock(mutex_);
    for (auto it = waiting_.begin(); it != waiting_.end(); ++it) {
      if (it->first.second != id) continue;
      auto node = waiting_.extract(it);
      node.key().first = clock_.Elapsed();
      waiting_.insert(std::move(node));
      return;
    }
  }

  // Moves the clock and calls what is due, in order, also what those calls add.
  void Advance(absl::Duration duration) {
    const absl::Duration end = clock_.Elapsed() + duration;
    while (true) {
      TimerCallback callback;
      {
        const std::lock_guard lock(mutex_);
        if (waiting_.empty() || waiting_.begin()->first.first > end) break;
        const absl::Duration due = waiting_.begin()->first.first;
        if (due > clock_.Elapsed()) clock_.Advance(due - clock_.Elapsed());
        callback = std::move(waiting_.begin()->second);
        waiting_.erase(waiting_.begin());
      }
      callback(absl::OkStatus());
    }
    clock_.Advance(end - clock_.Elapsed());
  }

  // Callbacks that wait.
  int waiting() const {
    const std::lock_guard lock(mutex_);
    return static_cast<int>(waiting_.size());
  }

  // Every delay that was asked for, in order.
  std::vector<absl::Duration> delays() const {
    const std::lock_guard lock(mutex_);
    return delays_;
  }

 private:
  FakeClock& clock_;
  mutable std::mutex mutex_;
  std::map<std::pair<absl::Duration, Id>, TimerCallback> waiting_;
  std::vector<absl::Duration> delays_;
  Id next_id_ = 1;
};

}  // namespace flair::runtime
