// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/workers/circuit.h"

#include <algorithm>

namespace flair::orchestrator {

bool Circuit::Begin() {
  on_trial_ = open_;
  return on_trial_;
}

void Circuit::Succeed() {
  failures_in_a_row_ = 0;
  open_ = false;
  on_trial_ = false;
}

void Circuit::GiveUp(bool on_trial) {
  if (on_trial) on_trial_ = false;
}

bool Circuit::Fail(bool on_trial, absl::Duration now) {
  if (open_ && !on_trial) return false;
  on_trial_ = false;
  ++failures_in_a_row_;
  return OpenIfTooMany(now);
}

bool Circuit::Retract(int failures_before, absl::Duration now) {
  if (open_) return false;
  failures_in_a_row_ = std::max(failures_in_a_row_, failures_before) + 1;
  return OpenIfTooMany(now);
}

bool Circuit::OpenIfTooMany(absl::Duration now) {
  if (failures_in_a_row_ < failure_limit_) return false;
  open_ = true;
  trial_time_ = now + recovery_;
  return true;
}

}  // namespace flair::orchestrator
