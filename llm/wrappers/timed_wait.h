// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <utility>

#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/clock/clock.h"

namespace flair::llm {

// A wait that a cancellation cuts short, in whatever order the two begin. Both outlive it.
class TimedWait {
 public:
  TimedWait(runtime::Timer& timer, runtime::Cancellation& cancellation)
      : state_(std::make_shared<State>(timer)), on_cancel_(cancellation, [state = state_] { state->Hasten(); }) {}

  // Begins the wait, once. `callback` runs in the timer's thread after `delay`, or as soon as possible after the
  // cancellation; it may destroy this object.
  void Begin(absl::Duration delay, runtime::TimerCallback callback) {
    const std::shared_ptr<State> state = state_;
    state->id = state->timer.RunAfter(delay, std::move(callback));
    if (state->hastened) state->Hasten();
  }

  // Lets the callback run as soon as possible.
  void Hasten() { state_->Hasten(); }

 private:
  struct State {
    explicit State(runtime::Timer& waiting_timer) : timer(waiting_timer) {}
    void Hasten() {
      hastened = true;
      if (const runtime::Timer::Id begun = id; begun != 0) timer.Hasten(begun);
    }
    runtime::Timer& timer;
    std::atomic<runtime::Timer::Id> id = 0;
    std::atomic<bool> hastened = false;
  };

  const std::shared_ptr<State> state_;
  runtime::OnCancel on_cancel_;
};

}  // namespace flair::llm
