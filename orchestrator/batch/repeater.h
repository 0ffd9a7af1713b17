// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

#include "absl/time/time.h"

namespace flair::orchestrator {

// Calls a function at once and then again and again, on a thread of its own, until destroyed. Thread-safe.
class Repeater {
 public:
  // `step` says how long after its end it is to be called again.
  explicit Repeater(std::function<absl::Duration()> step) : step_(std::move(step)), thread_([this] { Run(); }) {}

  // Returns when no call is under way.
  ~Repeater() {
    {
      std::lock_guard lock(mutex_);
      stopping_ = true;
      wake_.notify_all();
    }
    thread_.join();
  }

  // Calls it as soon as may be, whatever it said.
  void Wake() {
    std::lock_guard lock(mutex_);
    woken_ = true;
    wake_.notify_all();
  }

 private:
  void Run() {
    std::unique_lock lock(mutex_);
    while (!stopping_) {
      woken_ = false;
      lock.unlock();
      const absl::Duration pause = step_();
      lock.lock();
      wake_.wait_for(lock, absl::ToChronoMilliseconds(pause), [this] { return stopping_ || woken_; });
    }
  }

  const std::function<absl::Duration()> step_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool stopping_ = false;
  bool woken_ = false;
  std::thread thread_;
};

}  // namespace flair::orchestrator
