// SPDX-License-Identifier: GPL-3.0-or-later
// For how many a room is, in the words of briefs.
#include "language_worker/handbook/reading/other_words.h"

#include <gtest/gtest.h>

#include "gmock/gmock.h"
#include "gtest/gtest.h"

namespace flair::language {

namespace {

int PeopleIn(const char* text) {
  const std::vector<Token> tokens = TokensOf(text);
  std::vector<bool> used(tokens.size(), false);
  return ReadPeople(tokens, used).value_or(0);
}

TEST(ReadPeople, CountsByAnyNounOfPersons) {
  const struct {
    const char* text;
    int people;
  } kCases[] = {{"A library for forty readers.", 40},
                {"A room for six people", 6},
                {"A den where seven of us fit", 7},
                {"A dining room that seats twelve.", 12},
                {"A dining room seating fourteen", 14},
                {"A dining room for a family of five.", 5},
                {"A classroom where twenty students learn.", 20},
                {"A classroom for a class of 30.", 30},
                {"A hall with room for about 25 quiet worshippers.", 25},
                {"A team room, ten staff.", 10},
                {"A classroom for a dozen pupils.", 12},
                {"An office for 8 gardeners", 8},
                {"A dining room for 6.", 6},
                {"A kitchen for two adults and three children", 5},
                {"A reading room with forty seats", 40},
                {"A dormitory that sleeps eight.", 8},
                {"An 8-person meeting room", 8}};
  for (const auto& one : kCases) EXPECT_EQ(PeopleIn(one.text), one.people) << one.text;
}

TEST(ReadPeople, OtherNumbersAreNotOfPeople) {
  for (const char* text : {"A bedroom 4 by 5 m.", "An office for two computers.", "A bedroom for 14 m2.",
                           "A room for a person.", "A study with three bookshelves.", "A room for 3 months.",
                           "A bedroom for a writer.", "A hall for 200 flowers"}) {
    EXPECT_EQ(PeopleIn(text), 0) << text;
  }
}

}  // namespace

namespace {

int YearOf(const char* text) {
  const std::vector<Token> tokens = TokensOf(text);
  std::vector<bool> used(tokens.size(), false);
  return ReadYear(tokens, used).value_or(0);
}

TEST(ReadYear, IsReadHoweverItIsSaid) {
  EXPECT_EQ(YearOf("A ship's cabin around 1750."), 1750);
  EXPECT_EQ(YearOf("A 1920s kitchen"), 1920);
  EXPECT_EQ(YearOf("An 18th-century study"), 1750);
  EXPECT_EQ(YearOf("A room of 1200 by 1500 mm"), 0);
  EXPECT_EQ(YearOf("A bedroom in 2024 style for 4 people"), 0);
}

}  // namespace

namespace {

TEST(ReadsAsEnglish, KnowsOtherLanguages) {
  EXPECT_TRUE(ReadsAsEnglish(TokensOf("A bedroom that is 4m x 5m.")));
  EXPECT_TRUE(ReadsAsEnglish(TokensOf("Bedroom 4m x 5m")));
  EXPECT_FALSE(ReadsAsEnglish(TokensOf("Ein Schlafzimmer mit einem Doppelbett und zwei Nachttischen.")));
  EXPECT_FALSE(ReadsAsEnglish(TokensOf("Una sala de estar de 5 por 4 metros con un sofá y un piano.")));
  EXPECT_FALSE(ReadsAsEnglish(TokensOf("Une chambre de 4 m sur 5 avec un grand lit et deux tables de nuit.")));
}

}  // namespace

}  // namespace flair::language
