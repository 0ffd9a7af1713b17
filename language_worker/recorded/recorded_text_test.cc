// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/recorded/recorded_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flair::language {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class ConstraintTextTest : public ::testing::Test {
 protected:
  ConstraintTextTest() {
    const char* const names[] = {"desk", "armchair", "desk chair", "potted plant", "potted plant"};
    for (int i = 0; i < 5; ++i) {
      objects_[i].set_name(names[i]);
      pointers_.push_back(&objects_[i]);
    }
  }
  // "0 1: text" for each sentence.
  std::vector<std::string> Read(std::string_view text, ConstraintTextKind kind) {
    const ObjectNames names(pointers_);
    std::vector<std::string> lines;
    for (const RecordedSentence& sentence : ReadConstraintText({"t", text, kind, names, zones_}, conversion_)) {
      std::string line;
      for (const int object : sentence.objects) line += std::to_string(object) + " ";
      lines.push_back(line + (sentence.must ? "! " : "") + sentence.text);
    }
    return lines;
  }
  std::vector<std::string> Intra(std::string_view text) { return Read(text, ConstraintTextKind::kIntra); }
  std::vector<std::string> Inter(std::string_view text) { return Read(text, ConstraintTextKind::kInter); }

  v1::Object objects_[5];
  std::vector<const v1::Object*> pointers_;
  const std::vector<std::string> zones_ = {"working", "reading"};
  Conversion conversion_;
};

TEST_F(ConstraintTextTest, BulletsAreAboutTheObjectOfTheirHeading) {
  EXPECT_THAT(
      Intra("Sure! Here is the list for each object:\n\n"
            "### Working: Desk - 1.4m x 0.7m\n- Should be against a wall.\n- **Access**: the front must be free.\n"
            "### Desk Chair\n- Near the desk.\n\nThese constraints keep it practical."),
      ElementsAre("0 Should be against a wall.", "0 ! Access: the front must be free.", "2 Near the desk."));
  EXPECT_EQ(conversion_.lines, 3);
  EXPECT_EQ(conversion_.converted, 3);
}

TEST_F(ConstraintTextTest, LabelsBetweenHeadingAndBulletChangeNothing) {
  EXPECT_THAT(Intra("### Desk\n- **Distance from the armchair:**\n  - Should be 1m.\n- **Desk Chair (0.5m x 0.5m)**\n"
                    "  - Should be free."),
              ElementsAre("0 Should be 1m.", "2 Should be free."));
}

TEST_F(ConstraintTextTest, AnUnfinishedSentenceGoesOnInItsBullets) {
  EXPECT_THAT(Intra("### Desk\n- Avoid placement near:\n  - Doors\n  - Windows\n"),
              ElementsAre("0 Avoid placement near Doors", "0 Avoid placement near Windows"));
}

TEST_F(ConstraintTextTest, AHeadingAtTheIndentOfItsListIsOneToo) {
  EXPECT_THAT(Intra("**1. Reading:\n- Armchair: 0.8m (width) x 0.8m (length)**\n\n- Should face the room.\n"
                    "**2. Working:\n- Desk: 1.4m (width) x 0.7m (length)**\n\n- Should be free.\n"),
              ElementsAre("1 Should face the room.", "0 Should be free."));
}

TEST_F(ConstraintTextTest, SeveralOfAKindAreMeantTogether) {
  EXPECT_THAT(Intra("- **Potted Plants (x2)**\n  - Should not block doors."),
              ElementsAre("3 4 Should not block doors."));
}

TEST_F(ConstraintTextTest, PairsAreThoseOfTheHeadingElseThoseThatTheSentenceNames) {
  EXPECT_THAT(Inter("1. **Desk and Desk Chair**:\n   - Constraint: The chair should be in front.\n"
                    "2. The armchair should be away from the desk. It should face the potted plants.\n"),
              ElementsAre("0 2 The chair should be in front.", "1 0 The armchair should be away from the desk.",
                          "1 3 4 It should face the potted plants."));
}

TEST_F(ConstraintTextTest, TheInnermostHeadingWithAnObjectCounts) {
  EXPECT_THAT(Inter("1. Working:\n   - Desk Chair:\n     - Should be at the desk.\n   - Armchair:\n     - Near."),
              ElementsAre("2 Should be at the desk.", "1 Near."));
}

TEST_F(ConstraintTextTest, WhatNamesNoObjectIsKept) {
  EXPECT_THAT(Inter("1. Maintain a clear path through the room.\n"), IsEmpty());
  ASSERT_EQ(conversion_.remarks.size(), 1u);
  EXPECT_EQ(conversion_.remarks[0].line, 1);
  EXPECT_EQ(conversion_.remarks[0].text, "Maintain a clear path through the room.");
  EXPECT_EQ(conversion_.remarks[0].reason, "names none of the objects");
  EXPECT_EQ(conversion_.lines, 1);
  EXPECT_EQ(conversion_.converted, 0);
}

TEST_F(ConstraintTextTest, MarksAndRulesSayNothing) {
  EXPECT_THAT(Inter("---\n```\n\u2022 The **desk** is at the `wall`.\n***\n3) *The desk is 3.5 m from it.*\n"),
              ElementsAre("0 The desk is at the wall.", "0 The desk is 3.5 m from it."));
}

TEST(SplitSentences, EndsWhereACapitalFollowsButNotInBrackets) {
  EXPECT_THAT(SplitSentences("One is 0.5m wide. Two (e.g. Beams. And so on) is not. Three"),
              ElementsAre("One is 0.5m wide.", "Two (e.g. Beams. And so on) is not.", "Three"));
  EXPECT_THAT(SplitSentences("near e.g. Windows"), ElementsAre("near e.g. Windows"));
  EXPECT_THAT(SplitSentences("   "), IsEmpty());
}

TEST(Likeness, IsTheShareOfTheShorterTextsWords) {
  EXPECT_EQ(Likeness("The desk should be against a wall.", "Desk should be against the wall to save space"), 1);
  EXPECT_EQ(Likeness("against a wall", ""), 0);
  EXPECT_DOUBLE_EQ(Likeness("near door window", "near door socket lamp"), 2.0 / 3);
}

}  // namespace
}  // namespace flair::language
