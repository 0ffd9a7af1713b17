// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/text_table.h"

#include <gtest/gtest.h>

namespace flair::cli {
namespace {

TEST(TextTable, ColumnsAreAsWideAsTheirTitlesOrTheLeastWidth) {
  const TextTable table({"room", "a", "longer"}, 6, 3);
  EXPECT_EQ(table.Header(), "room     a longer\n-----------------\n");
  EXPECT_EQ(table.Row({"x", "1", "2"}), "x        1      2\n");
}

TEST(TextTable, ALongFirstCellIsCutAndALongOtherCellIsNot) {
  const TextTable table({"room", "a"}, 4, 1);
  EXPECT_EQ(table.Row({"bedroom", "12345"}), "bedr 12345\n");
}

}  // namespace
}  // namespace flair::cli
