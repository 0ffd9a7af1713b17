// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/progress/progress.h"

#include <gtest/gtest.h>

namespace flair::cli {
namespace {

TEST(SlowText, NamesTheModelThatHasNotAnsweredForTwentySeconds) {
  const std::string late = ", no answer of http://127.0.0.1:9 yet";
  EXPECT_EQ(SlowText("… room", absl::Milliseconds(19999), late), "… room, 19 s");
  EXPECT_EQ(SlowText("… room", absl::Seconds(20), late), "… room, 20 s, no answer of http://127.0.0.1:9 yet");
  EXPECT_EQ(SlowText("… solve", absl::Seconds(90), ""), "… solve, 90 s");
}

}  // namespace
}  // namespace flair::cli
