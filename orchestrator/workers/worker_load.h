// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>

#include "absl/time/time.h"

namespace flair::orchestrator {

// How busy and how fast a worker is, as far as our own calls tell. Times are those of Clock::Elapsed. Not thread-safe.
class WorkerLoad {
 public:
  // At most `limit` calls at once, at least 1.
  explicit WorkerLoad(int limit) : limit_(limit), window_(limit) {}

  void Begin(int64_t call, absl::Duration now) { in_flight_.emplace(call, now); }

  // A call ended: with an answer, which took as long as calls take; because the worker takes no more, whose share is
  // halved then, and which is left alone for a moment; or otherwise, which says at most that it is slow.
  void EndAnswered(int64_t call, absl::Duration now);
  void EndRefused(int64_t call, absl::Duration now);
  // Returns what it took.
  absl::Duration EndOtherwise(int64_t call, absl::Duration now);

  // The worker is there anew.
  void Forget();

  bool HasRoom(absl::Duration now) const {
    return static_cast<int>(in_flight_.size()) < static_cast<int>(window_) && now >= rest_end_;
  }
  // Until then it is left alone.
  absl::Duration rest_end() const { return rest_end_; }
  int in_flight() const { return static_cast<int>(in_flight_.size()); }

  // Moving mean of what calls took; zero when none has ended.
  absl::Duration mean() const { return mean_; }

  // What a call would take now: the mean, trusted less the older it is, so that a worker that was slow once is tried
  // again; at least as long as its oldest call has been waiting, so that a hanging one is noticed before its calls end.
  // `typical` where nothing is known.
  absl::Duration Estimate(absl::Duration now, absl::Duration typical) const;

 private:
  // Its duration.
  absl::Duration Remove(int64_t call, absl::Duration now);
  void Learn(absl::Duration duration, absl::Duration now);

  const int limit_;
  // Calls that it seems to take, [1, limit]: halved when it refuses one, grown by one for each window full of answers.
  double window_;
  // By number, and so by age.
  std::map<int64_t, absl::Duration> in_flight_;
  absl::Duration mean_;
  absl::Duration learnt_at_;
  absl::Duration rest_;
  absl::Duration rest_end_ = -absl::InfiniteDuration();
};

}  // namespace flair::orchestrator
