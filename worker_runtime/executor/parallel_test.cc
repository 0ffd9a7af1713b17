// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <vector>

#include "worker_runtime/executor/executor.h"

namespace flair::runtime {
namespace {

TEST(ForEach, RunsEachIndexOnceWhateverTheThreads) {
  for (int threads : {1, 2, 7}) {
    std::vector<int> runs(100, 0);
    EXPECT_TRUE(ForEach({threads, {}}, 100, [&](int i) { ++runs[i]; }).ok());
    EXPECT_EQ(runs, std::vector<int>(100, 1)) << threads;
  }
}

TEST(ForEach, AcceptsNothingToDo) {
  EXPECT_TRUE(ForEach({4, {}}, 0, [](int) { FAIL(); }).ok());
}

TEST(ForEach, EndsWhenNobodyWaitsAnyMore) {
  int runs = 0;
  const auto gone = [] { return absl::CancelledError("gone"); };
  EXPECT_TRUE(absl::IsCancelled(ForEach({1, gone}, 100, [&](int) { ++runs; })));
  EXPECT_EQ(runs, 1);
}

}  // namespace
}  // namespace flair::runtime
