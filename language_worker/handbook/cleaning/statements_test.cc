// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "language_worker/handbook/cleaning/clean_constraints.h"

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

namespace {

struct PairCase {
  const char* name;
  const char* first;
  const char* second;
  bool contradict;
};

Stance Of(const char* text, bool pair) {
  v1::Sentence sentence;
  sentence.set_text(text);
  sentence.add_subject_ids("desk");
  if (pair) sentence.add_subject_ids("bed");
  return StanceOf(sentence);
}

class Stances : public testing::TestWithParam<PairCase> {};

TEST_P(Stances, ContradictOnlyWhenNoLayoutFollowsBoth) {
  const auto of = [](const char* text) { return Of(text, std::string(text).find("bed") != std::string::npos); };
  EXPECT_EQ(Contradict(of(GetParam().first), of(GetParam().second)), GetParam().contradict);
  EXPECT_EQ(Contradict(of(GetParam().second), of(GetParam().first)), GetParam().contradict);
}

INSTANTIATE_TEST_SUITE_P(
    Pairs, Stances,
    testing::Values(
        PairCase{"wall_and_centre", "The desk is against a wall.", "The desk is in the centre of the room.", true},
        PairCase{"corner_and_off_walls", "The desk is in a corner.", "The desk is not against a wall.", true},
        PairCase{"two_walls", "The desk is against the north wall.", "The desk is against the south wall.", true},
        PairCase{"a_named_corner", "The desk's back is against the north wall.",
                 "The desk's left side is against the west wall.", false},
        PairCase{"wall_and_named_wall", "The desk is against a wall.", "The desk is against the south wall.", false},
        PairCase{"near_and_away", "The desk is near the window.", "The desk is away from the window.", true},
        PairCase{"other_features", "The desk is near the window.", "The desk is away from the door.", false},
        PairCase{"a_ring", "The desk is within 2 m of the bed.", "The desk is at least 1 m away from the bed.", false},
        PairCase{"no_ring", "The desk is within 1 m of the bed.", "The desk is at least 2 m away from the bed.", true},
        PairCase{"facing", "The desk faces the bed.", "The desk does not face the bed.", true},
        PairCase{"wall_and_window", "The desk is against a wall.", "The desk is near the window.", false}),
    [](const auto& info) { return info.param.name; });

}  // namespace

}  // namespace flair::language
