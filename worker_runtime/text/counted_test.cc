// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/text/counted.h"

#include "gtest/gtest.h"

namespace flair {
namespace {

TEST(Counted, TakesAnSForAllButOne) {
  EXPECT_EQ(Counted(0, "job"), "0 jobs");
  EXPECT_EQ(Counted(1, "job"), "1 job");
  EXPECT_EQ(Counted(2, "job"), "2 jobs");
  EXPECT_EQ(Counted(1, "stage agrees", "stages agree"), "1 stage agrees");
  EXPECT_EQ(Counted(3, "stage agrees", "stages agree"), "3 stages agree");
}

}  // namespace
}  // namespace flair
