// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/printable.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace flair::cli
