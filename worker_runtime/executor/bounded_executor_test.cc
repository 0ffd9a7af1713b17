// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/executor/bounded_executor.h"

#include <gtest/gtest.h>

#include <atomic>

#include "worker_runtime/executor/cancellation.h"
#include "worker_runtime/executor/test_gate.h"

namespace flair::runtime {
namespace {

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
  BoundedExecutor executor(3, 1);
  TestGate running[3];
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

}  // namespace
}  // namespace flair::runtime
