// SPDX-License-Identifier: GPL-3.0-or-later
// Somebody designs rooms while others do to the orchestrator what they can.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/fixtures/programs.h"
#include "tests/security/attacks.h"
#include "tests/security/orchestrator_caller.h"
#include "tests/security/secure_programs.h"

namespace flair::testing {
namespace {

TEST(FloodedOrchestrator, DesignsARoomForSomebodyElse) {
  const TestFolder folder;
  AllPrograms programs(folder.path());
  Attack attack(programs.orchestrator(), "/flair.v1.OrchestratorService/CreateJob");
  attack.WaitUntilUnderWay();
  const Finished design = RunProgram("flair",
                                     {"design", "A bedroom that is 3m x 4m.", "--out", (folder / "bedroom").string(),
                                      "--quiet", "--orchestrator", programs.orchestrator()},
                                     {{"FLAIR_HOME", (folder / "home").string()}});
  EXPECT_EQ(design.exit_code, 0) << design.err;
  EXPECT_TRUE(std::filesystem::exists(folder / "bedroom" / "plan.png"));
  fmt::print("meanwhile: {} connections, {} large messages refused; the orchestrator {} MiB\n",
             attack.connection_count(), attack.refused_count(), PeakMib(programs.orchestrator_program().process()));
  EXPECT_EQ(attack.taken_count(), 0);
  EXPECT_LT(PeakMib(programs.orchestrator_program().process()), 700);
}

TEST(FloodedOrchestrator, TellsWatchersOfEveryJob) {
  const TestFolder folder;
  AllPrograms programs(folder.path());
  OrchestratorCaller innocent(programs.orchestrator(), {});
  const auto before = innocent.CreateJob("A study that is 3m x 3m.", "before");
  ASSERT_TRUE(before.ok()) << before.status();
  Attack attack(programs.orchestrator(), "/flair.v1.OrchestratorService/CreateJob");
  attack.WaitUntilUnderWay();
  for (int i = 0; i < 3; ++i) {
    const auto job = innocent.CreateJob("A bedroom that is 3m x 4m.", fmt::format("during-{}", i));
    ASSERT_TRUE(job.ok()) << job.status();
    const auto end = innocent.EndOf(job->id());
    ASSERT_TRUE(end.ok()) << end.status();
    EXPECT_EQ(end->state(), v1::JOB_STATE_SUCCEEDED) << end->error();
  }
  const auto end = innocent.EndOf(before->id());
  ASSERT_TRUE(end.ok()) << end.status();
  EXPECT_EQ(end->state(), v1::JOB_STATE_SUCCEEDED) << end->error();
}

}  // namespace
}  // namespace flair::testing
