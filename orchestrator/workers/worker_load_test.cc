// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/workers/worker_load.h"

#include <gtest/gtest.h>

namespace flair::orchestrator {
namespace {

constexpr absl::Duration kTypical = absl::Milliseconds(50);

absl::Duration At(int seconds) { return absl::Seconds(seconds); }

TEST(WorkerLoad, HasRoomForAsManyCallsAsItMay) {
  WorkerLoad load(2);
  load.Begin(1, At(0));
  EXPECT_TRUE(load.HasRoom(At(0)));
  load.Begin(2, At(0));
  EXPECT_FALSE(load.HasRoom(At(0)));
  load.EndOtherwise(1, At(1));
  EXPECT_TRUE(load.HasRoom(At(1)));
}

TEST(WorkerLoad, HalvesItsShareWhenItRefusesAndGrowsItWithAnswers) {
  WorkerLoad load(16);
  for (int call = 0; call < 9; ++call) load.Begin(call, At(0));
  load.EndRefused(0, At(0));
  for (int call = 1; call < 9; ++call) load.EndAnswered(call, At(1));
  const auto room = [&](int first) {
    int count = 0;
    for (; load.HasRoom(At(2)); ++count) load.Begin(first + count, At(2));
    for (int i = 0; i < count; ++i) load.EndAnswered(first + i, At(2));
    return count;
  };
  EXPECT_EQ(room(100), 5) << "half of eight, and one for more than four answers";
  EXPECT_EQ(room(200), 6);
  for (int i = 3; i < 20; ++i) room(100 * i);
  EXPECT_EQ(room(5000), 16) << "never beyond its limit";
}

TEST(WorkerLoad, IsLeftAloneForAMomentWhenItRefusesLongerEachTime) {
  WorkerLoad load(4);
  absl::Duration now = At(0);
  absl::Duration last;
  for (int i = 0; i < 12; ++i) {
    load.Begin(i, now);
    load.EndRefused(i, now);
    EXPECT_FALSE(load.HasRoom(now));
    const absl::Duration rest = load.rest_end() - now;
    EXPECT_GE(rest, last);
    EXPECT_LE(rest, absl::Seconds(2));
    last = rest;
    now = load.rest_end();
    EXPECT_TRUE(load.HasRoom(now));
  }
  EXPECT_EQ(last, absl::Seconds(2));
}

TEST(WorkerLoad, CallsThatWereRefusedTogetherAreOneRefusal) {
  WorkerLoad load(16);
  for (int call = 0; call < 16; ++call) load.Begin(call, At(0));
  for (int call = 0; call < 15; ++call) load.EndRefused(call, At(0));
  load.EndAnswered(15, At(1));
  int room = 0;
  for (; load.HasRoom(At(1)); ++room) load.Begin(100 + room, At(1));
  EXPECT_EQ(room, 7);
}

TEST(WorkerLoad, ExpectsWhatCallsTook) {
  WorkerLoad load(4);
  EXPECT_EQ(load.Estimate(At(0), kTypical), kTypical);
  for (int i = 0; i < 50; ++i) {
    load.Begin(i, At(2 * i));
    load.EndAnswered(i, At(2 * i + 2));
  }
  EXPECT_EQ(load.Estimate(At(100), kTypical), At(2));
}

TEST(WorkerLoad, ForgetsWithTimeThatItWasSlow) {
  WorkerLoad load(4);
  load.Begin(1, At(0));
  load.EndAnswered(1, At(8));
  EXPECT_EQ(load.Estimate(At(8), kTypical), At(8));
  EXPECT_EQ(load.Estimate(At(8 + 81), kTypical), At(4)) << "a second and ten calls";
  EXPECT_LT(load.Estimate(At(8 + 81 * 8), kTypical), kTypical);
}

TEST(WorkerLoad, ACallThatHangsTellsBeforeItEnds) {
  WorkerLoad load(4);
  load.Begin(1, At(0));
  load.EndAnswered(1, At(1));
  load.Begin(2, At(1));
  EXPECT_EQ(load.Estimate(At(31), kTypical), At(30));
}

TEST(WorkerLoad, FailingFastMakesNobodyFaster) {
  WorkerLoad load(4);
  load.Begin(1, At(0));
  load.EndAnswered(1, At(4));
  for (int i = 2; i < 100; ++i) {
    load.Begin(i, At(4));
    load.EndOtherwise(i, At(4));
  }
  EXPECT_EQ(load.mean(), At(4));
}

}  // namespace
}  // namespace flair::orchestrator
