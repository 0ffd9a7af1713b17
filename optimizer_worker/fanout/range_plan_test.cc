// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "optimizer_worker/fanout/fan_out_runner.h"

namespace flair::optimizer {
namespace {

TEST(RangePlan, DealsEveryRestartOutOnceBeforeAnyTwice) {
  RangePlan plan(10, 7, 3, 0);
  const auto a = plan.Take(0), b = plan.Take(1), c = plan.Take(2);
  ASSERT_TRUE(a && b && c);
  EXPECT_EQ(a->first, 10);
  EXPECT_EQ(a->count, 3);
  EXPECT_EQ(b->first, 13);
  EXPECT_EQ(c->first, 16);
  EXPECT_EQ(c->count, 1);
  EXPECT_FALSE(plan.done());
}

TEST(RangePlan, AnIdleTakerRepeatsTheOldestUnfinishedPiece) {
  RangePlan plan(0, 2, 1, 0);
  const auto slow = plan.Take(0), quick = plan.Take(1);
  ASSERT_TRUE(slow && quick);
  EXPECT_TRUE(plan.Finish(*quick, 1));
  const auto hedge = plan.Take(1);
  ASSERT_TRUE(hedge);
  EXPECT_EQ(hedge->index, slow->index);
  EXPECT_TRUE(plan.Finish(*hedge, 1));
  EXPECT_TRUE(plan.done());
  EXPECT_FALSE(plan.Finish(*slow, 0)) << "the slow answer comes second";
}

TEST(RangePlan, NobodyRepeatsItsOwnPieceAndNoPieceIsRunByThree) {
  RangePlan plan(0, 1, 1, 0);
  ASSERT_TRUE(plan.Take(0));
  EXPECT_FALSE(plan.Take(0));
  ASSERT_TRUE(plan.Take(1));
  EXPECT_FALSE(plan.Take(2));
}

TEST(RangePlan, AnOwnThreadTakesAPieceThatAnyNumberOfPeersHoldOnTo) {
  RangePlan plan(0, 1, 1, 2);
  const auto first_peer = plan.Take(2), second_peer = plan.Take(3);
  ASSERT_TRUE(first_peer && second_peer);
  EXPECT_FALSE(plan.Take(4)) << "a third peer";
  const auto own = plan.Take(0);
  ASSERT_TRUE(own);
  EXPECT_FALSE(plan.Take(1)) << "an own thread runs it already";
  EXPECT_TRUE(plan.Finish(*own, 0));
  EXPECT_TRUE(plan.done());
}

TEST(RangePlan, APieceThatWasGivenUpIsTakenAgain) {
  RangePlan plan(0, 1, 1, 0);
  const auto dead = plan.Take(0);
  const auto hedge = plan.Take(1);
  ASSERT_TRUE(dead && hedge);
  plan.GiveUp(*dead, 0);
  plan.GiveUp(*hedge, 1);
  const auto again = plan.Take(2);
  ASSERT_TRUE(again);
  EXPECT_TRUE(plan.Finish(*again, 2));
  EXPECT_TRUE(plan.done());
}

}  // namespace
}  // namespace flair::optimizer
