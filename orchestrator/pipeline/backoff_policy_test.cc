// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/pipeline/backoff_policy.h"

#include <gtest/gtest.h>

namespace flair::orchestrator {
namespace {

TEST(BackoffPolicy, GrowsToItsLimitWithinTheSpread) {
  const BackoffPolicy policy;
  const absl::Status full = absl::ResourceExhaustedError("the queue is full");
  for (int attempt = 0; attempt < 100; ++attempt) {
    const absl::Duration most = std::min(absl::Milliseconds(100) * (1 << std::min(attempt, 10)), absl::Seconds(2));
    const absl::Duration delay = *policy.DelayAfter(full, attempt, "j1");
    EXPECT_LE(delay, most);
    EXPECT_GE(delay, most / 2);
  }
}

TEST(BackoffPolicy, SpreadsCallersThatFailedTogether) {
  const BackoffPolicy policy;
  const absl::Status down = absl::UnavailableError("down");
  EXPECT_NE(policy.DelayAfter(down, 0, "j1"), policy.DelayAfter(down, 0, "j2"));
}

TEST(BackoffPolicy, EndsWithTheLastAttempt) {
  const BackoffPolicy policy{.unavailable_attempt_limit = 3};
  const absl::Status down = absl::UnavailableError("down");
  EXPECT_TRUE(policy.DelayAfter(down, 1, "j1").has_value());
  EXPECT_FALSE(policy.DelayAfter(down, 2, "j1").has_value());
}

TEST(WaitUnlessCancelled, ReturnsAtOnceWhenCancelled) {
  runtime::CallContext call;
  call.cancellation().Cancel();
  WaitUnlessCancelled(absl::Hours(1), call);
}

}  // namespace
}  // namespace flair::orchestrator
