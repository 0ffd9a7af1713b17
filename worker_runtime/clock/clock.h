// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>

#include "absl/status/status.h"
#include "absl/time/time.h"

namespace flair::runtime {

// Where the time comes from. An argument everywhere, so that tests need neither sleep nor wall clock. Thread-safe.
class Clock {
 public:
  virtual ~Clock() = default;

  // Time of day, for people and for deadlines.
  virtual absl::Time Now() const = 0;

  // Time since some fixed moment; never jumps. For durations.
  virtual absl::Duration Elapsed() const = 0;
};

// The clock of the machine. Lives for the whole process.
Clock& SystemClock();

// OK when it is time (or was hastened); CANCELLED when the timer ends before.
using TimerCallback = std::function<void(const absl::Status&)>;

// Runs functions later. An argument everywhere, so that tests need not sleep. Thread-safe.
class Timer {
 public:
  // Names one function that waits; never 0.
  using Id = int64_t;

  virtual ~Timer() = default;

  // Calls `callback` exactly once, not before `delay` has passed, in the timer's thread; it must not block. When the
  // timer has ended, calls it from within this call.
  virtual Id RunAfter(absl::Duration delay, TimerCallback callback) = 0;

  // Calls the callback as soon as possible instead of at its time, still in the timer's thread, never from within this
  // call: for callers that must not wait any longer, such as a call that was cancelled. Does nothing when it has run.
  virtual void Hasten(Id id) = 0;
};

}  // namespace flair::runtime
