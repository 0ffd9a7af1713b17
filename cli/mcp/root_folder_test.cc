// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mcp/root_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/stat.h>

#include <fstream>
#include <sstream>

namespace flair::cli::mcp {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class RootFolderTest : public ::testing::Test {
 protected:
  RootFolderTest() {
    std::string pattern = (fs::temp_directory_path() / "flair_root_XXXXXX").string();
    base_ = fs::canonical(mkdtemp(pattern.data()));
    fs::create_directories(base_ / "root");
    fs::create_directories(base_ / "outside");
  }
  ~RootFolderTest() override { fs::remove_all(base_); }

  absl::StatusOr<std::string> Write(const std::string& path, bool any = false) {
    const auto ours = [](const std::string&, const std::string& content) { return content.starts_with("ours"); };
    return RootFolder::Open(base_ / "root")->Write(path, "ours, new", {.any = any, .ours = ours});
  }
  static std::string Read(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  }

  fs::path base_;
};

TEST_F(RootFolderTest, WritesBelowItAndMakesFolders) {
  const auto written = Write("a/b/plan.png");
  ASSERT_TRUE(written.ok()) << written.status();
  EXPECT_EQ(*written, (base_ / "root/a/b/plan.png").string());
  EXPECT_EQ(Read(*written), "ours, new");
  EXPECT_TRUE(Write((base_ / "root/c.png").string()).ok()) << "a whole path below it";
  EXPECT_TRUE(Write("./d.png").ok());
  size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(base_ / "root")) count += entry.is_regular_file();
  EXPECT_EQ(count, 3u) << "nothing else is left behind";
}

TEST_F(RootFolderTest, NoPathLeavesIt) {
  fs::create_directory_symlink(base_ / "outside", base_ / "root/link");
  fs::create_symlink(base_ / "outside/new", base_ / "root/file");
  fs::create_directory_symlink(".", base_ / "root/self");
  std::ofstream(base_ / "root/plain") << "x";
  for (const std::string path :
       {std::string("../outside/x"), std::string("a/../../outside/x"), (base_ / "outside/x").string(),
        std::string("/etc/x"), std::string("link/x"), std::string("file"), std::string("self/x"),
        std::string("plain/x"), (base_ / "root/../outside/x").string(), (base_ / "rooted").string(), std::string("a/"),
        std::string("."), std::string("a\nb"), std::string("a\0b", 3)}) {
    EXPECT_TRUE(absl::IsInvalidArgument(Write(path, true).status())) << path;
  }
  EXPECT_TRUE(fs::is_empty(base_ / "outside"));
}

TEST_F(RootFolderTest, ReplacesOnlyItsOwnUnlessToldTo) {
  ASSERT_TRUE(Write("a").ok());
  EXPECT_TRUE(Write("a").ok());
  std::ofstream(base_ / "root/b") << "somebody's";
  const auto refused = Write("b");
  EXPECT_TRUE(absl::IsAlreadyExists(refused.status()));
  EXPECT_THAT(std::string(refused.status().message()), HasSubstr("overwrite"));
  EXPECT_EQ(Read(base_ / "root/b"), "somebody's");
  EXPECT_TRUE(Write("b", true).ok());
  EXPECT_EQ(Read(base_ / "root/b"), "ours, new");
  fs::create_directory(base_ / "root/folder");
  EXPECT_FALSE(Write("folder", true).ok());
  ASSERT_EQ(::mkfifo((base_ / "root/pipe").c_str(), 0600), 0);
  EXPECT_FALSE(Write("pipe", true).ok());
}

TEST_F(RootFolderTest, AFolderThatIsNotThereIsRefused) {
  const auto root = RootFolder::Open(base_ / "nowhere");
  EXPECT_THAT(std::string(root.status().message()), HasSubstr("--root: "));
}

}  // namespace
}  // namespace flair::cli::mcp
