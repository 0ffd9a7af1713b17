// SPDX-License-Identifier: GPL-3.0-or-later
// The same brief and seed give the same bytes, whoever does the work and however often it was interrupted.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include "tests/fixtures/programs.h"

namespace flair::testing {
namespace {

using ::testing::HasSubstr;

constexpr char kBrief[] = "A bedroom that is 3m x 4m.";
constexpr const char* kFiles[] = {"brief.pb",  "room.pb",        "zones.pb",         "objects.pb",
                                  "style.pb",  "constraints.pb", "constraints.json", "graph.pb",
                                  "layout.pb", "layout.json",    "plan.png"};

void ExpectSame(const std::filesystem::path& a, const std::filesystem::path& b) {
  for (const char* name : kFiles) {
    const std::string bytes = ReadAll(a / name);
    EXPECT_FALSE(bytes.empty()) << name;
    EXPECT_TRUE(bytes == ReadAll(b / name)) << name << " differs";
  }
}

void Design(const TestFolder& folder, const std::string& out, const std::string& home,
            const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments = {"design", kBrief, "--seed", "7", "--out", folder / out, "--quiet"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Finished run = RunProgram("flair", arguments, {{"FLAIR_HOME", folder / home}});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
}

TEST(Determinism, TheNumberOfThreadsChangesNothing) {
  const TestFolder folder;
  Design(folder, "one", "home_one", {"--threads", "1"});
  Design(folder, "four", "home_four", {"--threads", "4"});
  ExpectSame(folder / "one", folder / "four");
}

TEST(Determinism, SeparateProgramsGiveTheSameBytesAsOne) {
  const TestFolder folder;
  AllPrograms programs(folder.path());
  ASSERT_NE(programs.orchestrator(), "");
  Design(folder, "embedded", "home");
  Design(folder, "separate", "unused", {"--orchestrator", programs.orchestrator()});
  ExpectSame(folder / "embedded", folder / "separate");
}

TEST(Determinism, AllProgramsOfOneBuildSayTheSameBuildAndSoDoTheirArtifacts) {
  const std::string build = BuildOfFlair();
  ASSERT_FALSE(build.empty());
  const TestFolder folder;
  AllPrograms programs(folder.path());
  const Finished doctor = RunProgram("flair",
                                     {"doctor", programs.language(), programs.translator(), programs.optimizer(),
                                      programs.renderer(), programs.orchestrator()},
                                     {{"FLAIR_HOME", folder / "home"}});
  EXPECT_EQ(doctor.exit_code, 0) << doctor.out;
  for (const char* name : {"language", "translator", "optimizer", "renderer", "orchestrator"}) {
    EXPECT_THAT(doctor.out, HasSubstr(std::string("flair-") + name + " answers, build " + build + "\n"));
  }
  Design(folder, "out", "home");
  for (const char* name : kFiles) {
    if (!std::string(name).ends_with(".pb")) continue;
    EXPECT_THAT(RunProgram("flair", {"inspect", folder / "out" / name}).out, HasSubstr(", build " + build + "\n"));
  }
}

TEST(Determinism, AnotherSeedGivesAnotherRoom) {
  const TestFolder folder;
  Design(folder, "seven", "home");
  const Finished run = RunProgram("flair", {"design", kBrief, "--seed", "8", "--out", folder / "eight", "--quiet"},
                                  {{"FLAIR_HOME", folder / "home"}});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(ReadAll(folder / "seven" / "layout.pb"), ReadAll(folder / "eight" / "layout.pb"));
}

// Kills the program after the first, second, ... finished stage; each time the next run must end as if nothing had
// been.
TEST(Crash, AKilledDesignLeavesNothingHalfWrittenAndGoesOn) {
  const TestFolder folder;
  Design(folder, "undisturbed", "home_undisturbed");
  for (int stages = 1; stages <= 9; stages += 2) {
    const std::string home = folder / ("home" + std::to_string(stages));
    const std::filesystem::path out = folder / ("out" + std::to_string(stages));
    {
      Process process(ProgramPath("flair"), {"design", kBrief, "--seed", "7", "--out", out.string(), "--json"},
                      {{"FLAIR_HOME", home}});
      std::string seen;
      for (int i = 0; i < stages * 2; ++i) seen += process.WaitForLine("{");
      process.Signal(SIGKILL);
      process.Wait();
    }
    EXPECT_FALSE(std::filesystem::exists(out)) << "after " << stages << " stages";
    const Finished again = RunProgram("flair", {"design", kBrief, "--seed", "7", "--out", out.string(), "--quiet"},
                                      {{"FLAIR_HOME", home}});
    ASSERT_EQ(again.exit_code, 0) << again.err;
    ExpectSame(folder / "undisturbed", out);
  }
}

TEST(Crash, FinishedStagesAreNotDoneAgain) {
  const TestFolder folder;
  Design(folder, "first", "home");
  const Finished again = RunProgram("flair", {"design", kBrief, "--seed", "7", "--out", folder / "second", "--json"},
                                    {{"FLAIR_HOME", folder / "home"}});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_NE(again.out.find("JOB_EVENT_KIND_STAGE_REUSED"), std::string::npos);
  EXPECT_EQ(again.out.find("\"JOB_EVENT_KIND_STAGE_FINISHED\",\"stage\":\"solve\""), std::string::npos);
  ExpectSame(folder / "first", folder / "second");
}

}  // namespace
}  // namespace flair::testing
