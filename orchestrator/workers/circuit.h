// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/time/time.h"

namespace flair::orchestrator {

// Whether a worker is called although calls to it failed. Closed: it is. Open, after `failure_limit` failures in a row:
// not until `recovery` has passed; then one call is made on trial, whose end closes the circuit or opens it anew. Times
// are those of Clock::Elapsed. Not thread-safe.
class Circuit {
 public:
  Circuit(int failure_limit, absl::Duration recovery) : failure_limit_(failure_limit), recovery_(recovery) {}

  bool Allows(absl::Duration now) const { return !open_ || (now >= trial_time_ && !on_trial_); }

  // Failed too often and has not shown since that it works.
  bool open() const { return open_; }

  // When an open one allows a trial.
  absl::Duration trial_time() const { return trial_time_; }

  int failures_in_a_row() const { return failures_in_a_row_; }

  // A call begins, which Allows() allowed. Says whether it is the trial.
  bool Begin();

  // The ends of a call. A call that was not on trial and fails while the circuit is open began before it opened, and
  // changes nothing.
  void Succeed();
  void GiveUp(bool on_trial);
  // Says whether the circuit opened.
  bool Fail(bool on_trial, absl::Duration now);

  // An answer that had been taken for a success was none. `failures_before`: failures in a row before that success.
  bool Retract(int failures_before, absl::Duration now);

  // The worker is there anew: the next call is the trial.
  void AllowTrial() { trial_time_ = -absl::InfiniteDuration(); }

 private:
  bool OpenIfTooMany(absl::Duration now);

  const int failure_limit_;
  const absl::Duration recovery_;
  int failures_in_a_row_ = 0;
  bool open_ = false;
  bool on_trial_ = false;
  absl::Duration trial_time_;
};

}  // namespace flair::orchestrator
