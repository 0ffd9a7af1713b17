// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include "absl/status/status.h"
#include "absl/time/time.h"
#include "worker_runtime/clock/clock.h"
#include "worker_runtime/executor/cancellation.h"

namespace flair::runtime {

// What a handler knows about the call it answers. Knows nothing of gRPC, so that handlers and solvers can be tested
// without it. Thread-safe after construction.
class CallContext {
 public:
  CallContext(std::string request_id, absl::Time deadline, const Clock& clock)
      : request_id_(std::move(request_id)), deadline_(deadline), clock_(clock) {}

  // A call without id or deadline, for tests and for commands that call a library directly.
  CallContext() : CallContext("", absl::InfiniteFuture(), SystemClock()) {}

  // The caller's key for this piece of work; the log key. May be empty.
  const std::string& request_id() const { return request_id_; }

  // When the caller stops waiting; absl::InfiniteFuture() when never.
  absl::Time deadline() const { return deadline_; }

  // True when nobody waits for the answer any more. Cheap enough to poll once per restart or per sentence.
  bool cancelled() const { return cancellation_.cancelled() || clock_.Now() >= deadline_; }

  // OK, or CANCELLED or DEADLINE_EXCEEDED: what a handler that stops early returns.
  absl::Status CheckAlive() const {
    if (cancellation_.cancelled()) return absl::CancelledError("the caller cancelled the call");
    if (clock_.Now() >= deadline_) return absl::DeadlineExceededError("the call's deadline has passed");
    return absl::OkStatus();
  }

  // To cancel the call, or to be told of it (see OnCancel).
  Cancellation& cancellation() { return cancellation_; }

 private:
  const std::string request_id_;
  const absl::Time deadline_;
  const Clock& clock_;
  Cancellation cancellation_;
};

}  // namespace flair::runtime
