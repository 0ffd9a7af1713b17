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

}  // namespace
}  // namespace flair::cli
