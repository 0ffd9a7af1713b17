// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/output_folder.h"

#include <gtest/gtest.h>

#include "tests/fixtures/programs.h"

namespace flair::cli {
namespace {

using ::flair::testing::ReadAll;
using ::flair::testing::TestFolder;
using ::flair::testing::WriteAll;

size_t EntryCount(const std::filesystem::path& folder) {
  return static_cast<size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

TEST(WriteOutputFolder, MakesTheFolderAndItsParents) {
  const TestFolder folder;
  const std::filesystem::path out = folder.path() / "a" / "b";
  ASSERT_TRUE(WriteOutputFolder(out, {{"one.txt", "1"}, {"two.txt", "2"}}).ok());
  EXPECT_EQ(ReadAll(out / "one.txt"), "1");
  EXPECT_EQ(EntryCount(folder / "a"), 1u) << "no temporary folder is left";
}

TEST(WriteOutputFolder, ReplacesItsOwnFilesAndKeepsOthers) {
  const TestFolder folder;
  const std::filesystem::path out = folder / "out";
  ASSERT_TRUE(WriteOutputFolder(out, {{"one.txt", "old"}}).ok());
  ASSERT_TRUE(WriteOutputFolder(out, {{"one.txt", "new"}}).ok());
  EXPECT_EQ(ReadAll(out / "one.txt"), "new");
  WriteAll(out / "mine.txt", "mine");
  ASSERT_TRUE(WriteOutputFolder(out, {{"one.txt", "newer"}}).ok());
  EXPECT_EQ(ReadAll(out / "one.txt"), "newer");
  EXPECT_EQ(ReadAll(out / "mine.txt"), "mine");
  EXPECT_EQ(EntryCount(folder.path()), 1u);
}

TEST(CheckOutputFolder, LeavesNothingBehind) {
  const TestFolder folder;
  EXPECT_TRUE(CheckOutputFolder(folder.path() / "a" / "b", {"one.txt"}).ok());
  EXPECT_EQ(EntryCount(folder.path()), 0u);
}

TEST(CheckOutputFolder, RefusesFilesOfOthersWithItsNames) {
  const TestFolder folder;
  WriteAll(folder / "report.md", "mine");
  const absl::Status status = CheckOutputFolder(folder.path(), {"report.md"});
  EXPECT_EQ(status.code(), absl::StatusCode::kFailedPrecondition);
  EXPECT_NE(std::string(status.message()).find("report.md, which is not Flair's"), std::string::npos);
}

TEST(WriteOutputFile, IsWholeOrNotThere) {
  const TestFolder folder;
  ASSERT_TRUE(WriteOutputFile(folder / "plan.png", "png").ok());
  EXPECT_EQ(ReadAll(folder / "plan.png"), "png");
  EXPECT_FALSE(WriteOutputFile(folder.path(), "png").ok());
  EXPECT_EQ(EntryCount(folder.path()), 1u);
}

}  // namespace
}  // namespace flair::cli
