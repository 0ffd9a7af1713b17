// SPDX-License-Identifier: GPL-3.0-or-later
// For how many a room is, in the words of briefs.
#include "language_worker/handbook/reading/people.h"

#include <gtest/gtest.h>

namespace flair::language {
namespace {

int PeopleIn(const char* text) {
  const std::vector<Token> tokens = Tokenize(text);
  std::vector<bool> used(tokens.size(), false);
  return ReadPeople(tokens, used).value_or(0);
}

TEST(ReadPeople, CountsByAnyNounOfPersons) {
  const struct {
    const char* text;
    int people;
  } kCases[] = {{"A library for forty readers.", 40},
                {"A room for six people", 6},
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
}  // namespace flair::language
