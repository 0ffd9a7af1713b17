// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "absl/time/time.h"

namespace flair::orchestrator {

// So many calls a minute, as a bucket that holds a minute's worth and fills evenly: bursts are taken, floods are not.
// Not thread-safe.
class RateLimit {
 public:
  RateLimit(int per_minute, absl::Duration now) : per_minute_(per_minute), filled_(per_minute), at_(now) {}

  int per_minute() const { return per_minute_; }

  // Takes one call; when none is left, says how long until one is. `now` never goes back (Clock::Elapsed).
  absl::Duration Take(absl::Duration now) {
    filled_ = std::min<double>(per_minute_, filled_ + absl::ToDoubleMinutes(now - at_) * per_minute_);
    at_ = now;
    if (filled_ < 1) return absl::Minutes((1 - filled_) / per_minute_);
    filled_ -= 1;
    return absl::ZeroDuration();
  }

 private:
  int per_minute_;
  double filled_;
  absl::Duration at_;
};

}  // namespace flair::orchestrator
