// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/http/event_loop.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "worker_runtime/testing/fakes.h"

namespace flair::llm {
namespace {

using ::testing::ElementsAre;

EventLoop::SocketCallback NoSockets() {
  return [](int, bool, bool) { ADD_FAILURE() << "no socket is watched"; };
}

TEST(EventLoop, RunsTasksInTheirOrder) {
  std::vector<int> ran;
  EventLoop loop(NoSockets());
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(loop.Post([&ran, i] { ran.push_back(i); }));
  loop.Stop();
  EXPECT_THAT(ran, ElementsAre(0, 1, 2, 3, 4));
}

TEST(EventLoop, RunsTimersInTheOrderOfTheirTimes) {
  std::vector<std::string> ran;
  runtime::TestGate all_ran;
  EventLoop loop(NoSockets());
  loop.Post([&] {
    // From within the loop, so that none is due before all are known.
    loop.RunAfter(absl::Milliseconds(6), [&](const absl::Status&) {
      ran.push_back("later");
      all_ran.Open();
    });
    loop.RunAfter(absl::Milliseconds(3), [&](const absl::Status&) { ran.push_back("sooner"); });
    loop.RunAfter(absl::ZeroDuration(), [&](const absl::Status&) { ran.push_back("at once"); });
  });
  all_ran.Wait();
  EXPECT_THAT(ran, ElementsAre("at once", "sooner", "later"));
}

TEST(EventLoop, AHastenedTimerRunsWithoutItsDelay) {
  runtime::TestGate ran;
  absl::Status status = absl::UnknownError("not run");
  EventLoop loop(NoSockets());
  const auto id = loop.RunAfter(absl::Hours(1), [&](const absl::Status& time) {
    status = time;
    ran.Open();
  });
  loop.Hasten(id);
  ran.Wait();
  EXPECT_TRUE(status.ok()) << status;
  loop.Hasten(id);
}

TEST(EventLoop, ADroppedTimerNeverRuns) {
  bool ran = false;
  EventLoop loop(NoSockets());
  loop.Drop(loop.RunAfter(absl::Hours(1), [&](const absl::Status&) { ran = true; }));
  loop.Stop();
  EXPECT_FALSE(ran);
}

TEST(EventLoop, StopTellsEveryTimerThatItIsCancelled) {
  std::vector<absl::StatusCode> codes;
  EventLoop loop(NoSockets());
  for (int i = 0; i < 3; ++i) {
    loop.RunAfter(absl::InfiniteDuration(), [&](const absl::Status& time) { codes.push_back(time.code()); });
  }
  loop.Stop();
  EXPECT_THAT(codes,
              ElementsAre(absl::StatusCode::kCancelled, absl::StatusCode::kCancelled, absl::StatusCode::kCancelled));
}

TEST(EventLoop, TakesNothingAfterItsEnd) {
  EventLoop loop(NoSockets());
  absl::Status in_last = absl::OkStatus();
  loop.Stop([&] { loop.RunAfter(absl::ZeroDuration(), [&](const absl::Status& time) { in_last = time; }); });
  EXPECT_EQ(in_last.code(), absl::StatusCode::kCancelled);
  EXPECT_FALSE(loop.Post([] { FAIL(); }));
  absl::Status after = absl::OkStatus();
  loop.RunAfter(absl::ZeroDuration(), [&](const absl::Status& time) { after = time; });
  EXPECT_EQ(after.code(), absl::StatusCode::kCancelled);
  loop.Stop();
}

}  // namespace
}  // namespace flair::llm
