// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/prompt_library.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace flair::llm {
namespace {

namespace fs = std::filesystem;
using ::testing::EndsWith;
using ::testing::HasSubstr;

const std::vector<PromptSpec> kSpecs = {{"zones", {"brief", "room"}, {"brief"}}, {"system", {}, {}}};

class PromptLibraryTest : public ::testing::Test {
 protected:
  PromptLibraryTest() {
    const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    root_ = fs::path(::testing::TempDir()) / ("prompts_" + name);
    fs::remove_all(root_);
    fs::create_directories(root_ / "own");
    fs::create_directories(root_ / "installed");
    Write("installed/zones.txt", "%% Asks for the zones.\nPlan {{brief}} for {{room}}.\n\n");
    Write("installed/system.txt", "You design rooms.");
  }
  ~PromptLibraryTest() override { fs::remove_all(root_); }

  void Write(const std::string& path, const std::string& text) { std::ofstream(root_ / path) << text; }

  absl::StatusOr<PromptLibrary> Load(bool own = true) {
    return PromptLibrary::Load(root_ / "installed", own ? root_ / "own" : fs::path(), kSpecs);
  }
  std::string Error() { return std::string(Load().status().message()); }

  fs::path root_;
};

TEST_F(PromptLibraryTest, FillsEveryPlaceholderOnceAndSendsNoRemarks) {
  const auto prompts = Load(/*own=*/false);
  ASSERT_TRUE(prompts.ok()) << prompts.status();
  EXPECT_EQ(prompts->Fill("zones", {{"brief", "{{room}} {{brief}}"}, {"room", "4 m x 5 m"}}),
            "Plan {{room}} {{brief}} for 4 m x 5 m.");
}

TEST_F(PromptLibraryTest, OwnFilesReplaceInstalledOnesAndTheVersionTells) {
  const std::string before = Load()->version();
  EXPECT_EQ(before, Load(/*own=*/false)->version());
  Write("own/zones.txt", "Zonen für {{brief}}!");
  const auto prompts = Load();
  ASSERT_TRUE(prompts.ok()) << prompts.status();
  EXPECT_EQ(prompts->Fill("zones", {{"brief", "x"}}), "Zonen für x!");
  EXPECT_EQ(prompts->Fill("system", {}), "You design rooms.");
  EXPECT_NE(prompts->version(), before);
}

TEST_F(PromptLibraryTest, RemarksAndLineEndsChangeNoVersion) {
  const std::string before = Load()->version();
  Write("own/zones.txt", "%% Something else.\r\nPlan {{brief}} for {{room}}.\r\n");
  EXPECT_EQ(Load()->version(), before);
}

TEST_F(PromptLibraryTest, MistakesAreNamedWithFileAndLine) {
  Write("own/zones.txt", "Plan\n{{brief}} and {{rooms}}.");
  EXPECT_THAT(Error(),
              EndsWith("own/zones.txt:2: {{rooms}} is not a placeholder of this prompt; it has {{brief}}, {{room}}"));
  Write("own/zones.txt", "Plan a room.");
  EXPECT_THAT(Error(), EndsWith("own/zones.txt: {{brief}} is not in the text"));
  Write("own/zones.txt", "%% nothing\n");
  EXPECT_THAT(Error(), EndsWith("own/zones.txt: the prompt is empty"));
  Write("own/zones.txt", "{{brief}} \xFF");
  EXPECT_THAT(Error(), EndsWith("own/zones.txt: the prompt is no UTF-8 text"));
  fs::remove(root_ / "own/zones.txt");
  fs::remove(root_ / "installed/zones.txt");
  EXPECT_THAT(Error(), HasSubstr("installed/zones.txt is missing"));
  fs::remove_all(root_ / "own");
  EXPECT_THAT(Error(), HasSubstr("own is not a folder"));
}

TEST(QuoteData, NothingInsideCanEndTheQuotation) {
  EXPECT_EQ(QuoteData("a \"room\"\n</brief> ü \\"), R"("a \"room\"\n\u003c/brief\u003e ü \\")");
}

}  // namespace
}  // namespace flair::llm
