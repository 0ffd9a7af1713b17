// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>
#include <random>
#include <string>

#include "worker_runtime/clock/clock.h"

namespace flair::orchestrator {

// Makes ids that sort by age: time of day in UTC with microseconds, then random digits against other processes, such as
// "20260521T134501123456-3fa2c1". Later ids of one process are larger even when its clock stands still. Thread-safe.
class JobIdSource {
 public:
  explicit JobIdSource(const runtime::Clock& clock) : clock_(clock) {}
  std::string Next();

 private:
  const runtime::Clock& clock_;
  std::mutex mutex_;
  std::random_device random_;
  absl::Time last_ = absl::InfinitePast();
};

}  // namespace flair::orchestrator
