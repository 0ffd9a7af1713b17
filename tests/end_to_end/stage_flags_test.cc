// SPDX-License-Identifier: GPL-3.0-or-later
// Single stages of a design asked of servers that the user names.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include "nlohmann/json.hpp"
#include "tests/fixtures/programs.h"

namespace flair::testing {
namespace {

using ::testing::HasSubstr;

constexpr char kListen[] = "runtime { listen_address: \"127.0.0.1:0\" log_level: \"error\" }\n";

class StageFlags : public ::testing::Test {
 protected:
  Finished Design(const std::string& out, const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {"design", "A bedroom that is 3m x 4m.", "--out", folder_ / out, "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunProgram("flair", arguments, {{"FLAIR_HOME", folder_ / ("home_of_" + out)}});
  }
  std::string Build(const std::string& artifact) const {
    return nlohmann::json::parse(ReadAll(folder_ / artifact))["producer"]["build"];
  }

  TestFolder folder_;
};

TEST_F(StageFlags, AllFourStagesElsewhereGiveTheSameBytes) {
  const AllPrograms programs(folder_.path());
  const Finished own = Design("own", {});
  ASSERT_EQ(own.exit_code, 0) << own.err;
  const Finished mixed =
      Design("mixed", {"--language", programs.language(), "--translator", programs.translator(), "--optimizer",
                       programs.optimizer(), "--renderer", programs.renderer(), "--view", "birdseye"});
  ASSERT_EQ(mixed.exit_code, 0) << mixed.err;
  for (const char* name : {"room.pb", "constraints.pb", "graph.pb", "layout.pb", "plan.png"}) {
    EXPECT_TRUE(ReadAll(folder_ / "own" / name) == ReadAll(folder_ / "mixed" / name)) << name;
  }
  EXPECT_TRUE(std::filesystem::exists(folder_ / "mixed" / "birdseye.png"));
}

TEST_F(StageFlags, ArtifactsAndTheReportTellWhoMadeThem) {
  const ServerProgram other("../test_bin/flair_other_optimizer", kListen, folder_.path());
  const Finished run = Design("room", {"--optimizer", other.address()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(Build("room/layout.json"), "another-build");
  EXPECT_EQ(Build("room/graph.json"), BuildOfFlair());
  EXPECT_THAT(ReadAll(folder_ / "room/report.md"), HasSubstr("| another-build |"));
  // The layout of another build is not taken for one's own.
  const Finished again = Design("room", {});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(Build("room/layout.json"), BuildOfFlair());
}

TEST_F(StageFlags, AStageThatIsNotThereIsNamedAndNothingIsWritten) {
  for (const auto& [flag, service] : {std::pair{"--language", "LanguageService"},
                                      {"--translator", "TranslatorService"},
                                      {"--optimizer", "OptimizerService"},
                                      {"--renderer", "RendererService"}}) {
    const Finished run = Design("room", {flag, "127.0.0.1:1"});
    EXPECT_EQ(run.exit_code, 3) << flag;
    EXPECT_THAT(run.err,
                HasSubstr(std::string("flair: ") + flag + " 127.0.0.1:1: no flair.v1." + service + " answers there: "));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "room"));
}

TEST_F(StageFlags, WhatCannotBeGivenTogetherIsRefused) {
  const Finished run = Design("room", {"--optimizer", "127.0.0.1:1", "--orchestrator", "127.0.0.1:2"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.err,
            "flair: --optimizer 127.0.0.1:1: not with --orchestrator 127.0.0.1:2, which uses the stages of its own "
            "config; set there: stages { optimizer: \"127.0.0.1:1\" }\n");
  const Finished model = Design("room", {"--language", "127.0.0.1:1", "--translator", "127.0.0.1:2", "--model", "m"});
  EXPECT_EQ(model.exit_code, 2);
  EXPECT_THAT(model.err,
              HasSubstr("flair: --model: not with both --language 127.0.0.1:1 and --translator 127.0.0.1:2"));
}

TEST_F(StageFlags, AServerThatGoesAwayInTheMiddleIsNamedWithItsFlag) {
  ServerProgram renderer("flair-renderer", kListen, folder_.path());
  // Its store holds the design but for the picture.
  Process design(
      ProgramPath("flair"),
      {"design", "A bedroom that is 3m x 4m.", "--out", folder_ / "room", "--json", "--renderer", renderer.address()},
      {{"FLAIR_HOME", folder_ / "home"}});
  EXPECT_NE(design.WaitForLine("{"), "");
  renderer.process().Signal(SIGKILL);
  const Finished run = design.Wait();
  EXPECT_EQ(run.exit_code, 3) << run.err;
  EXPECT_THAT(run.err, HasSubstr("renderer worker at " + renderer.address() + " is not reachable: "));
  EXPECT_THAT(run.err, HasSubstr("; start it or fix --renderer"));
}

}  // namespace
}  // namespace flair::testing
