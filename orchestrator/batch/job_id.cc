// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/batch/job_id.h"

#include <fmt/format.h>

#include <algorithm>

namespace flair::orchestrator {

std::string JobIdSource::Next() {
  std::lock_guard lock(mutex_);
  last_ = std::max(clock_.Now(), last_ + absl::Microseconds(1));
  const std::string seconds = absl::FormatTime("%Y%m%dT%H%M%S", last_, absl::UTCTimeZone());
  const int64_t microseconds = absl::ToUnixMicros(last_) % 1000000;
  return fmt::format("{}{:06}-{:06x}", seconds, microseconds, random_() & 0xffffffu);
}

}  // namespace flair::orchestrator
