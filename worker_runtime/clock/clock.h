// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

#include "absl/time/clock.h"
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
inline Clock& SystemClock() {
  class MachineClock final : public Clock {
    absl::Time Now() const override { return absl::Now(); }
    absl::Duration Elapsed() const override {
      return absl::FromChrono(std::chrono::steady_clock::now().time_since_epoch());
    }
  };
  static MachineClock clock;
  return clock;
}

}  // namespace flair::runtime
