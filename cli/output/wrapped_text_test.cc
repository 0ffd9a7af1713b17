// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/wrapped_text.h"

#include "gtest/gtest.h"

namespace flair::cli {
namespace {

TEST(Wrapped, KeepsFiguresWithTheirUnitAndLosesNoWord) {
  EXPECT_EQ(Wrapped("at most 0.50 m away", 13, "  "), "at most\n  0.50 m away");
  EXPECT_EQ(Wrapped("turned by 90 degrees", 16, ""), "turned by\n90 degrees");
  EXPECT_EQ(Wrapped("of 4 men", 4, ""), "of 4\nmen");
  EXPECT_EQ(Wrapped("unbreakable word", 4, ""), "unbreakable\nword");
  EXPECT_EQ(Wrapped("", 10, ""), "");
}

TEST(Wrapped, BeginsWhereTheFirstLineDoesAndFillsEveryLine) {
  EXPECT_EQ(Wrapped("a bc d", 8, "    ", 4), "a bc\n    d");
  EXPECT_EQ(Wrapped("abcd efgh", 9, ""), "abcd efgh");
  EXPECT_EQ(Wrapped("abcd efgh", 8, ""), "abcd\nefgh");
}

TEST(Wrapped, CountsCharactersAndNotBytes) {
  EXPECT_EQ(ColumnsOf("Größe · ½"), 9u);
  EXPECT_EQ(Wrapped("größe größe", 11, ""), "größe größe");
}

}  // namespace
}  // namespace flair::cli
