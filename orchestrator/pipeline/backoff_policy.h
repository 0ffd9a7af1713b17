// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "absl/status/status.h"
#include "absl/time/time.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::orchestrator {

// When a call of a stage is made again. UNAVAILABLE: a worker is down or was just lost; a few times, so that a restart
// is bridged and a worker that was never started is soon reported. RESOURCE_EXHAUSTED: a queue is full; until the
// deadline. Nothing else is made again.
struct BackoffPolicy {
  int unavailable_attempt_limit = 6;
  absl::Duration first_delay = absl::Milliseconds(100);
  double growth = 2.0;
  absl::Duration longest_delay = absl::Seconds(2);

  // How long to wait after the failure of attempt `attempt` (0 is the first) before the next; nothing when there is no
  // next. Spread by up to a half of itself, by `key`, so that callers that failed together do not come back together.
  std::optional<absl::Duration> DelayAfter(const absl::Status& failure, int attempt, const std::string& key) const;
};

// RESOURCE_EXHAUSTED as gRPC says it of messages over the limit; those never get smaller.
bool IsMessageTooLarge(const absl::Status& status);

// Waits; returns early when the call is cancelled. A function so that tests need not wait.
using Waiter = std::function<void(absl::Duration, runtime::CallContext&)>;
void WaitUnlessCancelled(absl::Duration duration, runtime::CallContext& call);

}  // namespace flair::orchestrator
