// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/cleaning/split.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flair::language {
namespace {

using testing::ElementsAre;

TEST(SplitStatements, LeavesSingleStatementsAlone) {
  for (const char* text : {"The bed is against a wall.", "The sofa is between the lamp and the door.",
                           "The left and right sides of the bed are accessible.", "", "and", "; "}) {
    EXPECT_THAT(SplitStatements(text), ElementsAre(text));
  }
}

TEST(SplitStatements, SplitsDoorsAndWindows) {
  EXPECT_THAT(SplitStatements("The bed should not block windows or doors."),
              ElementsAre("The bed should not block windows.", "The bed should not block doors."));
}

TEST(SplitStatements, GivesEveryPlaceItsSubject) {
  EXPECT_THAT(SplitStatements("The desk should be against a wall and near a socket."),
              ElementsAre("The desk should be against a wall.", "The desk should be near a socket."));
  EXPECT_THAT(SplitStatements("The sofa faces the window and is against a wall."),
              ElementsAre("The sofa faces the window.", "The sofa is against a wall."));
}

TEST(SplitStatements, SplitsAtSemicolons) {
  EXPECT_THAT(SplitStatements("The bed is central; the desk is near a window."),
              ElementsAre("The bed is central.", "The desk is near a window."));
}

}  // namespace
}  // namespace flair::language
