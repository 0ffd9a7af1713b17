// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

}  // namespace flair::runtime
