// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "orchestrator/batch/repeater.h"
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
