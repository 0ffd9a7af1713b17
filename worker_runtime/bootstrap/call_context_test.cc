// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/bootstrap/call_context.h"

#include <gtest/gtest.h>

#include "worker_runtime/clock/fake_clock.h"

namespace flair::runtime {
namespace {

TEST(CallContext, IsAliveUntilItsDeadline) {
  FakeClock clock;
  CallContext call("r", clock.Now() + absl::Seconds(2), clock);
  EXPECT_TRUE(call.CheckAlive().ok());
  clock.Advance(absl::Seconds(2));
  EXPECT_TRUE(call.cancelled());
  EXPECT_EQ(call.CheckAlive().code(), absl::StatusCode::kDeadlineExceeded);
}

TEST(CallContext, IsAliveUntilCancelled) {
  CallContext call;
  EXPECT_FALSE(call.cancelled());
  call.cancellation().Cancel();
  EXPECT_TRUE(call.cancelled());
  EXPECT_EQ(call.CheckAlive().code(), absl::StatusCode::kCancelled);
}

}  // namespace
}  // namespace flair::runtime
