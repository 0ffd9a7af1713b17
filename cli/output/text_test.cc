// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/text.h"

#include <gtest/gtest.h>

#include "gtest/gtest.h"

namespace flair::cli {
namespace {

TEST(Printable, LeavesNothingThatSteersATerminal) {
  EXPECT_EQ(Printable("a\x1b[31mred\x07\x7f\r\xc2\x9b"
                      "31m"),
            "a [31mred     31m");
  EXPECT_EQ(Printable("two\nlines\tand größe, ✓"), "two\nlines\tand größe, ✓");
}

TEST(PrintableLine, IsOneLine) { EXPECT_EQ(PrintableLine("a\nb\tc\x1b"), "a b c "); }

TEST(Shortened, CutsBetweenCharactersAndSaysSo) {
  EXPECT_EQ(Shortened("größe", 5), "größe");
  EXPECT_EQ(Shortened("größer", 5), "größ…");
  EXPECT_EQ(Shortened("😀😀😀", 2), "😀…");
  EXPECT_EQ(Shortened("ab", 1), "…");
  EXPECT_EQ(Shortened("ab", 0), "");
}

TEST(TextTable, ColumnsAreAsWideAsTheirTitlesOrTheLeastWidth) {
  const TextTable table({"room", "a", "longer"}, 6, 3);
  EXPECT_EQ(table.Header(), "room     a longer\n-----------------\n");
  EXPECT_EQ(table.Row({"x", "1", "2"}), "x        1      2\n");
}

TEST(TextTable, ALongFirstCellIsCutAndALongOtherCellIsNot) {
  const TextTable table({"room", "a"}, 4, 1);
  EXPECT_EQ(table.Row({"bedroom", "12345"}), "bedr 12345\n");
}

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
