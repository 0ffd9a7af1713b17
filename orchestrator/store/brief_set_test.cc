// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/brief_set.h"

#include <gtest/gtest.h>

namespace flair::orchestrator {
namespace {

TEST(BriefSet, RemembersUntilItIsToldOtherwise) {
  BriefSet briefs;
  briefs.Add("a", briefs.generation());
  briefs.Add("b", briefs.generation());
  EXPECT_TRUE(briefs.Contains("a"));
  briefs.Forget("a");
  EXPECT_FALSE(briefs.Contains("a"));
  EXPECT_TRUE(briefs.Contains("b"));
  briefs.ForgetAll();
  EXPECT_FALSE(briefs.Contains("b"));
}

TEST(BriefSet, DoesNotTakeWhatWasFoundOutBeforeItWasToldOtherwise) {
  BriefSet briefs;
  const int64_t seen = briefs.generation();
  briefs.Forget("a");
  briefs.Add("a", seen);
  EXPECT_FALSE(briefs.Contains("a"));
  const int64_t seen_later = briefs.generation();
  briefs.ForgetAll();
  briefs.Add("a", seen_later);
  EXPECT_FALSE(briefs.Contains("a"));
}

TEST(BriefSet, StaysSmall) {
  BriefSet briefs;
  for (int i = 0; i < 100'000; ++i) briefs.Add(std::to_string(i), briefs.generation());
  EXPECT_FALSE(briefs.Contains("0"));
  EXPECT_TRUE(briefs.Contains("99999"));
}

}  // namespace
}  // namespace flair::orchestrator
