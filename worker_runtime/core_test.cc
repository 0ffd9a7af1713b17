// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <atomic>

#include "gtest/gtest.h"
#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/executor/executor.h"
#include "worker_runtime/testing/fakes.h"
#include "worker_runtime/text/counted.h"
#include "worker_runtime/text/read_number.h"

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

TEST(BoundedExecutor, RunsEveryTaskItTook) {
  std::atomic<int> ran = 0;
  int taken = 0;
  BoundedExecutor executor(4, 1000);
  for (int i = 0; i < 500; ++i) taken += executor.TrySubmit([&] { ++ran; }) ? 1 : 0;
  executor.Stop();
  EXPECT_EQ(taken, 500);
  EXPECT_EQ(ran, 500);
}

TEST(BoundedExecutor, RefusesWhatDoesNotFitTheQueue) {
  TestGate running;
  TestGate release;
  BoundedExecutor executor(1, 2);
  ASSERT_TRUE(executor.TrySubmit([&] {
    running.Open();
    release.Wait();
  }));
  running.Wait();
  EXPECT_TRUE(executor.TrySubmit([] {}));
  EXPECT_TRUE(executor.TrySubmit([] {}));
  EXPECT_FALSE(executor.TrySubmit([] {}));
  EXPECT_EQ(executor.queued(), 2);
  release.Open();
}

TEST(BoundedExecutor, RunsWaitingTasksBeforeItStops) {
  TestGate release;
  std::atomic<int> ran = 0;
  BoundedExecutor executor(1, 10);
  executor.TrySubmit([&] { release.Wait(); });
  for (int i = 0; i < 5; ++i) executor.TrySubmit([&] { ++ran; });
  release.Open();
  executor.Stop();
  EXPECT_EQ(ran, 5);
}

TEST(BoundedExecutor, TakesNothingAfterStop) {
  BoundedExecutor executor(2, 10);
  executor.Stop();
  EXPECT_FALSE(executor.TrySubmit([] {}));
}

TEST(BoundedExecutor, UsesAllItsThreads) {
  TestGate release;
  TestGate running[3];
  BoundedExecutor executor(3, 1);
  for (TestGate& gate : running) {
    ASSERT_TRUE(executor.TrySubmit([&] {
      gate.Open();
      release.Wait();
    }));
  }
  for (TestGate& gate : running) gate.Wait();
  release.Open();
}

TEST(Cancellation, RunsCallbacksOnceAndLateOnesAtOnce) {
  Cancellation cancellation;
  int early = 0;
  int gone = 0;
  int late = 0;
  OnCancel first(cancellation, [&] { ++early; });
  {
    OnCancel second(cancellation, [&] { ++gone; });
  }
  EXPECT_FALSE(cancellation.cancelled());
  cancellation.Cancel();
  cancellation.Cancel();
  OnCancel third(cancellation, [&] { ++late; });
  EXPECT_TRUE(cancellation.cancelled());
  EXPECT_EQ(early, 1);
  EXPECT_EQ(gone, 0);
  EXPECT_EQ(late, 1);
}

TEST(ReadNumber, TakesWhatPeopleWriteAndNothingElse) {
  for (const auto& [text, value] : {std::pair("2", 2.0), {"-0.35", -0.35}, {"+.5", 0.5}, {"1e3", 1000.0}}) {
    EXPECT_EQ(ReadNumber(text), value) << text;
  }
  for (const char* text : {"", "+", "+-1", "0x10", "inf", "nan", "1e999", "2m", " 2", "1,5"}) {
    EXPECT_EQ(ReadNumber(text), std::nullopt) << text;
  }
}

TEST(Counted, TakesAnSForAllButOne) {
  EXPECT_EQ(Counted(0, "job"), "0 jobs");
  EXPECT_EQ(Counted(1, "job"), "1 job");
  EXPECT_EQ(Counted(2, "job"), "2 jobs");
  EXPECT_EQ(Counted(1, "stage agrees", "stages agree"), "1 stage agrees");
  EXPECT_EQ(Counted(3, "stage agrees", "stages agree"), "3 stages agree");
}

}  // namespace
}  // namespace flair::runtime
