// SPDX-License-Identifier: GPL-3.0-or-later
// Real programs that meet a server of another version of the protocol.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/fixtures/programs.h"
#include "tests/fixtures/worker_speaker.h"

namespace flair::testing {
namespace {

using ::testing::HasSubstr;

TEST(OtherVersion, DoctorTellsIt) {
  const WorkerSpeaker server("their-optimizer", {"flair.v2"});
  const TestFolder folder;
  const Finished run = RunProgram("flair", {"doctor", server.address()}, {{"FLAIR_HOME", folder / "home"}});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.out, HasSubstr("their-optimizer speaks flair.v2, this program flair.v1"));
  EXPECT_THAT(run.out, HasSubstr("Start a version of it there that speaks flair.v1."));
}

TEST(OtherVersion, ADesignEndsWithASentence) {
  const WorkerSpeaker server("their-optimizer", {"flair.v2"});
  const TestFolder folder;
  std::string stages;
  for (const char* stage : {"language", "translator", "optimizer", "renderer"}) {
    stages += std::string(stage) + ": \"" + server.address() + "\" ";
  }
  const ServerProgram orchestrator("flair-orchestrator",
                                   "runtime { listen_address: \"127.0.0.1:0\" log_level: \"error\" }\nstore_path: \"" +
                                       (folder / "store").string() + "\"\nstages { " + stages + "}\n",
                                   folder.path());
  ASSERT_NE(orchestrator.address(), "");
  const Finished run = RunProgram(
      "flair", {"design", "A bedroom.", "--out", folder / "out", "--quiet", "--orchestrator", orchestrator.address()});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_EQ(run.err, "flair: language worker at " + server.address() +
                         ": their-optimizer speaks flair.v2, this program flair.v1; start a version of it that does or "
                         "fix stages.language\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

}  // namespace
}  // namespace flair::testing
