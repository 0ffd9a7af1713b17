// SPDX-License-Identifier: GPL-3.0-or-later
// `flair contract` as people and programs run it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nlohmann/json.hpp"
#include "tests/contract/servers.h"

namespace flair::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(ContractCommand, TellsCheckByCheckWhatAGoodServerKeeps) {
  const StageProgram translator(*contract::FindStage("translator"));
  const Finished run = RunProgram("flair", {"contract", "translator", "--target", translator.address()});
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_THAT(run.out, HasSubstr("flair.v1.TranslatorService of flair-translator"));
  EXPECT_THAT(run.out, HasSubstr("Translate refuses an empty sentence"));
  EXPECT_THAT(run.out, HasSubstr(" 0 broken, 0 skipped"));
}

TEST(ContractCommand, ABrokenPromiseIsTheEndAndSaysWhatWouldBeRight) {
  const StageProgram good(*contract::FindStage("optimizer"));
  const SpoiltOptimizer server(good.address(), {.spoil_code = [](int) { return 0; }});
  const Finished run =
      RunProgram("flair", {"contract", "optimizer", "--target", server.address(), "--only", "no objects"});
  EXPECT_EQ(run.exit_code, 8) << run.out << run.err;
  EXPECT_THAT(run.out, HasSubstr("sent     Solve with no objects"));
  EXPECT_THAT(run.out, HasSubstr("got      OK"));
  EXPECT_THAT(run.out, HasSubstr("right is INVALID_ARGUMENT"));
  EXPECT_THAT(run.err, HasSubstr("breaks 1 of 3 promises"));
}

TEST(ContractCommand, JsonIsAloneOnStandardOutput) {
  const StageProgram language(*contract::FindStage("language"));
  const Finished run =
      RunProgram("flair", {"contract", "language", "--target", language.address(), "--only", "kept", "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  const nlohmann::json report = nlohmann::json::parse(run.out, nullptr, false);
  ASSERT_TRUE(report.is_object()) << run.out;
  EXPECT_EQ(report["broken"], 0);
  EXPECT_EQ(report["checks"].size(), report["kept"]);
  EXPECT_THAT(run.err, HasSubstr("A room that the brief brings is kept"));
}

TEST(ContractCommand, NobodyThereIsSaid) {
  TestFolder folder;
  const Finished run = RunProgram("flair", {"contract", "renderer", "--target", "unix:" + (folder / "none").string()});
  EXPECT_EQ(run.exit_code, 3) << run.err;
  EXPECT_THAT(run.err, HasSubstr("no gRPC server answers there"));
}

TEST(ContractCommand, BadArgumentsAreNamed) {
  const std::pair<std::vector<std::string>, std::string> rows[] = {
      {{"contract", "optimiser", "--target", "127.0.0.1:1"}, "STAGE"},
      {{"contract", "optimizer"}, "--target"},
      {{"contract", "--target", "127.0.0.1:1"}, "STAGE"},
      {{"contract", "optimizer", "--target", "nowhere"}, "HOST:PORT"},
      {{"contract", "optimizer", "--list", "--only", "no such check"}, "--only"}};
  for (const auto& [arguments, named] : rows) {
    const Finished run = RunProgram("flair", arguments);
    EXPECT_EQ(run.exit_code, 2) << named;
    EXPECT_THAT(run.err, HasSubstr(named));
  }
}

TEST(ContractCommand, TheReferenceIsWhatTheCommandSays) {
  const Finished run = RunProgram("flair", {"contract", "--list", "--markdown"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(ReadAll(std::filesystem::path(FLAIR_SOURCE_DIR) / "docs" / "contract.md"), run.out)
      << "make it anew: flair contract --list --markdown > docs/contract.md";
}

}  // namespace
}  // namespace flair::testing
