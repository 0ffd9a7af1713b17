// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "orchestrator/batch/work_queue.h"
#include "spdlog/logger.h"
#include "worker_runtime/clock/clock.h"

namespace flair::orchestrator {

// Forgets what ended long ago: alone standing jobs, and batches as a whole. In small steps with pauses, so that who
// works hardly notices; any number of processes may do it at once. The arguments outlive it. Thread-safe.
class Sweeper {
 public:
  // Without `keep_ended`, only ends deletions that a process which died had begun.
  Sweeper(WorkQueue& queue, ArtifactStore& artifacts, const runtime::Clock& clock, spdlog::logger& logger,
          std::optional<absl::Duration> keep_ended)
      : queue_(queue), artifacts_(artifacts), clock_(clock), logger_(logger), keep_ended_(keep_ended) {}
  // As Stop.
  ~Sweeper() { Stop(); }

  // Sweeps now and then from a thread of its own.
  void Start();
  void Stop();

  // One step: some hundred jobs at most. `done` when all that was to go has gone.
  absl::StatusOr<Deleted> Step();

 private:
  void Run();
  absl::Status DeleteAll(const EndedPage& page, Deleted& deleted);

  WorkQueue& queue_;
  ArtifactStore& artifacts_;
  const runtime::Clock& clock_;
  spdlog::logger& logger_;
  const std::optional<absl::Duration> keep_ended_;
  // Where the next page of Step begins.
  std::string next_;

  std::mutex mutex_;
  std::condition_variable wake_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace flair::orchestrator
