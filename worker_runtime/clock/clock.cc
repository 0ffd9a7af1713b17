// SPDX-License-Identifier: GPL-3.0-or-later
#include "absl/time/clock.h"

#include <chrono>

#include "worker_runtime/clock/clock.h"

namespace flair::runtime {
namespace {

class SystemClockImpl final : public Clock {
 public:
  absl::Time Now() const override { return absl::Now(); }
  absl::Duration Elapsed() const override {
    return absl::FromChrono(std::chrono::steady_clock::now().time_since_epoch());
  }
};

}  // namespace

Clock& SystemClock() {
  static SystemClockImpl clock;
  return clock;
}

}  // namespace flair::runtime
