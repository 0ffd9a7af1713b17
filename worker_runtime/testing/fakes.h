// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include "worker_runtime/clock/clock.h"

namespace flair::runtime {

// A clock that stands still until a test moves it. Thread-safe.
class FakeClock final : public Clock {
 public:
  explicit FakeClock(absl::Time now = absl::FromUnixSeconds(1700000000)) : start_(now) {}

  absl::Time Now() const override { return start_ + Elapsed(); }

  absl::Duration Elapsed() const override {
    std::lock_guard lock(mutex_);
    return elapsed_;
  }

  void Advance(absl::Duration duration) {
    std::lock_guard lock(mutex_);
    elapsed_ += duration;
  }

 private:
  const absl::Time start_;
  mutable std::mutex mutex_;
  absl::Duration elapsed_;
};

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

// Holds threads back until it is opened, so that tests fix an order without sleeping. Thread-safe.
class TestGate {
 public:
  void Open() {
    std::lock_guard lock(mutex_);
    open_ = true;
    opened_.notify_all();
  }
  void Wait() {
    std::unique_lock lock(mutex_);
    opened_.wait(lock, [this] { return open_; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable opened_;
  bool open_ = false;
};

}  // namespace flair::runtime
