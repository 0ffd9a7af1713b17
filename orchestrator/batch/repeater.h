// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "orchestrator/batch/work_queue.h"
#include "spdlog/logger.h"
#include "worker_runtime/clock/clock.h"

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

// Forgets what ended long ago: alone standing jobs, and batches as a whole. In small steps with pauses, so that who
// works hardly notices; any number of processes may do it at once. The arguments outlive it. Thread-safe.
class Sweeper {
 public:
  // Without `keep_ended`, only ends deletions that a process which died had begun.
  Sweeper(WorkQueue& queue, ArtifactStore& artifacts, const runtime::Clock& clock, spdlog::logger& logger,
          std::optional<absl::Duration> keep_ended)
      : queue_(queue), artifacts_(artifacts), clock_(clock), logger_(logger), keep_ended_(keep_ended) {}

  // Sweeps now and then from a thread of its own, until Stop or its end.
  void Start() {
    repeater_.emplace([this] { return StepAndPause(); });
  }
  void Stop() { repeater_.reset(); }

  // One step: some hundred jobs at most. `done` when all that was to go has gone.
  absl::StatusOr<Deleted> Step();

 private:
  absl::Duration StepAndPause();
  absl::Status DeleteAll(const EndedPage& page, Deleted& deleted);

  WorkQueue& queue_;
  ArtifactStore& artifacts_;
  const runtime::Clock& clock_;
  spdlog::logger& logger_;
  const std::optional<absl::Duration> keep_ended_;
  // Where the next page of Step begins.
  std::string next_;
  bool failed_ = false;
  std::optional<Repeater> repeater_;
};

}  // namespace flair::orchestrator
