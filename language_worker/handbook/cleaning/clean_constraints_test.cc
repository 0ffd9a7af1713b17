// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/cleaning/clean_constraints.h"

#include <gtest/gtest.h>

#include <string>

namespace flair::language {
namespace {

v1::ConstraintList Sentences(std::initializer_list<std::pair<const char*, double>> texts) {
  v1::ConstraintList list;
  for (const auto& [text, weight] : texts) {
    v1::Sentence& sentence = *list.add_sentences();
    sentence.set_id("s" + std::to_string(list.sentences_size()));
    sentence.set_text(text);
    sentence.set_weight(weight);
    sentence.add_subject_ids("bed");
  }
  return list;
}

TEST(CleanConstraints, MergesWhatSaysTheSame) {
  const auto cleaned =
      CleanConstraints(Sentences({{"The bed is against a wall.", 1}, {"Bed should be against the wall", 2}}));
  ASSERT_EQ(cleaned.sentences_size(), 1);
  EXPECT_EQ(cleaned.sentences(0).weight(), 2);
  EXPECT_EQ(cleaned.cleaning_steps(0).action(), v1::CLEANING_ACTION_MERGED);
}

TEST(CleanConstraints, SplitsDoorsAndWindows) {
  const auto cleaned = CleanConstraints(Sentences({{"The bed does not block doors or windows.", 1}}));
  ASSERT_EQ(cleaned.sentences_size(), 2);
  EXPECT_EQ(cleaned.sentences(0).text(), "The bed does not block doors.");
  EXPECT_EQ(cleaned.sentences(1).text(), "The bed does not block windows.");
  EXPECT_EQ(cleaned.sentences(1).made_from_ids(0), "s1");
  EXPECT_NE(cleaned.sentences(0).id(), "s1");
}

TEST(CleanConstraints, OfTwoThatContradictTheWeightierStays) {
  const auto cleaned =
      CleanConstraints(Sentences({{"The bed is against a wall.", 1}, {"The bed is not against a wall.", 2}}));
  ASSERT_EQ(cleaned.sentences_size(), 1);
  EXPECT_EQ(cleaned.sentences(0).id(), "s2");
  EXPECT_EQ(cleaned.cleaning_steps(0).action(), v1::CLEANING_ACTION_CONTRADICTION_REMOVED);
}

TEST(CleanConstraints, CutsWordsThatSayNothing) {
  const auto cleaned = CleanConstraints(Sentences({{"Ensure the front is accessible.", 1}}));
  EXPECT_EQ(cleaned.sentences(0).text(), "The front is accessible.");
}

TEST(CleanConstraints, ChangesNothingTwice) {
  const auto once =
      CleanConstraints(Sentences({{"Ensure it does not block windows or doors.", 1}, {"The bed is central.", 1}}));
  const auto twice = CleanConstraints(once);
  EXPECT_TRUE(twice.cleaning_steps().empty());
  EXPECT_EQ(twice.sentences_size(), once.sentences_size());
}

}  // namespace
}  // namespace flair::language
