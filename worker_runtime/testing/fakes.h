// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <mutex>

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
