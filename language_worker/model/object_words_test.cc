// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "language_worker/model/prompt_text.h"
#include "language_worker/service/testing/model_session.h"

namespace flair::language {
namespace {

TEST(ObjectWords, IdsBecomeWordsAndNothingElseChanges) {
  ModelSession session;
  session.DescribeRoom().IgnoreError();
  session.PlanZones().IgnoreError();
  session.ListObjects().IgnoreError();
  const ObjectWords words(session.objects(), session.room());
  EXPECT_EQ(words.InWords("The nightstand_2 is left of the Double_Bed."),
            "The second nightstand is left of the double bed.");
  EXPECT_EQ(words.InWords("double_bed is away from window_1 and door_1."), "Double bed is away from window and door.");
  EXPECT_EQ(words.InWords("The desk_chair_3 is 0.5 m from the desk."), "The desk_chair_3 is 0.5 m from the desk.");
  EXPECT_EQ(words.InWords("Das Bücher_regal – 0,5 m."), "Das Bücher_regal – 0,5 m.");
  EXPECT_EQ(words.InWords(""), "");
}

}  // namespace
}  // namespace flair::language
