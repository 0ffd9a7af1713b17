// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/solve_flags.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "fmt/format.h"

namespace flair::cli {
namespace {

using ::testing::HasSubstr;

std::string FileWith(const std::string& text) {
  const std::string path = fmt::format("{}/options_{}.txt", ::testing::TempDir(), getpid());
  std::ofstream(path) << text;
  return path;
}

std::string ErrorOf(const SolveFlags& flags) {
  const absl::StatusOr<v1::SolveOptions> options = ReadSolveFlags(flags);
  EXPECT_EQ(options.status().code(), absl::StatusCode::kInvalidArgument);
  return std::string(options.status().message());
}

TEST(SolveFlags, WithoutFlagsOnlyTheSeedIsSet) {
  const absl::StatusOr<v1::SolveOptions> options = ReadSolveFlags({});
  ASSERT_TRUE(options.ok()) << options.status();
  EXPECT_EQ(options->ShortDebugString(), "seed: 0");
}

TEST(SolveFlags, FlagsGoBeforeTheFile) {
  SolveFlags flags;
  flags.file = FileWith("seed: 3 max_restart_count: 5 lambdas { zone: 1 balanced: 2 } tolerances { absolute: 1e-6 }");
  flags.restarts = 9;
  flags.lambdas = {"balanced=0.5"};
  flags.tolerances = {"max_evaluation_count=80"};
  const absl::StatusOr<v1::SolveOptions> options = ReadSolveFlags(flags);
  ASSERT_TRUE(options.ok()) << options.status();
  EXPECT_EQ(options->seed(), 3);
  EXPECT_EQ(options->max_restart_count(), 9);
  EXPECT_EQ(options->lambdas().zone(), 1);
  EXPECT_EQ(options->lambdas().balanced(), 0.5);
  EXPECT_EQ(options->tolerances().absolute(), 1e-6);
  EXPECT_EQ(options->tolerances().max_evaluation_count(), 80);
}

TEST(SolveFlags, TheTimeLimitKeepsItsFraction) {
  SolveFlags flags;
  flags.time_limit_s = 1.25;
  const absl::StatusOr<v1::SolveOptions> options = ReadSolveFlags(flags);
  ASSERT_TRUE(options.ok()) << options.status();
  EXPECT_EQ(options->time_limit().seconds(), 1);
  EXPECT_EQ(options->time_limit().nanos(), 250000000);
}

TEST(SolveFlags, AnUnknownFactorIsToldTheKnownOnes) {
  SolveFlags flags;
  flags.lambdas = {"balance=3"};
  EXPECT_THAT(ErrorOf(flags), HasSubstr("--lambda: balance=3: should be NAME=VALUE with one of door_overlap, "));
}

TEST(SolveFlags, ValuesThatAreNoNumbersAreNamed) {
  for (const std::string& text : {"balanced", "balanced=", "balanced=much", "balanced=nan", "balanced=inf"}) {
    SolveFlags flags;
    flags.lambdas = {text};
    EXPECT_THAT(ErrorOf(flags), HasSubstr("--lambda: " + text + ": should be balanced=VALUE with a number"));
  }
  SolveFlags flags;
  flags.tolerances = {"max_evaluation_count=1.5"};
  EXPECT_THAT(ErrorOf(flags), HasSubstr("a whole number"));
}

TEST(SolveFlags, AFileThatDoesNotParseIsToldWhere) {
  SolveFlags flags;
  flags.file = FileWith("seed: 3\nlambdas { balance: 2 }");
  EXPECT_THAT(ErrorOf(flags), HasSubstr(":2: column 18"));
}

}  // namespace
}  // namespace flair::cli
