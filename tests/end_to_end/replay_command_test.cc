// SPDX-License-Identifier: GPL-3.0-or-later
// flair replay, with a real store and real servers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include "nlohmann/json.hpp"
#include "orchestrator/store/job_store.h"
#include "orchestrator/store/local_artifacts.h"
#include "tests/fixtures/programs.h"

namespace flair::testing {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr char kBrief[] = "A bedroom that is 3m x 4m.";

json LastLine(const std::string& out) {
  if (out.size() < 2) return {};
  return json::parse(out.substr(out.rfind('\n', out.size() - 2) + 1), nullptr, false);
}

class ReplayCommand : public ::testing::Test {
 protected:
  Finished Flair(const std::vector<std::string>& arguments) const {
    return RunProgram("flair", arguments, {{"FLAIR_HOME", folder_ / "home"}});
  }
  // The id of a new job.
  std::string Design(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"design", kBrief, "--seed", "7", "--out", folder_ / "out", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Finished run = Flair(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return LastLine(run.out).value("job_id", "");
  }
  Finished Replay(const std::string& job, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"replay", job};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return Flair(arguments);
  }
  // As if the job had been given another layout the first time.
  void MoveFirstObjectIn(const std::string& job) const {
    auto jobs = *orchestrator::JobStore::Open(folder_ / "home");
    const auto artifacts = *orchestrator::LocalArtifacts::Open(folder_ / "home" / "artifacts");
    store::v1::JobRecord record = *jobs->jobs().Load(job);
    for (v1::ArtifactRef& ref : *record.mutable_job()->mutable_artifacts()) {
      if (ref.kind() != v1::ARTIFACT_KIND_SOLVED_LAYOUT) continue;
      v1::Artifact layout = *artifacts->Get(ref.id());
      layout.mutable_solved_layout()->mutable_placements(0)->set_x_m(1.25);
      ref = *artifacts->Put(layout);
    }
    ASSERT_TRUE(jobs->jobs().Save(record, record.events_size()).ok());
  }

  TestFolder folder_;
};

TEST_F(ReplayCommand, TheSameComesOutAndTheJobsSaySo) {
  const std::string job = Design();
  const Finished run = Replay(job);
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("brief        agrees\n"), HasSubstr("report       agrees\n"),
                             HasSubstr("of " + job + ": 12 stages agree\n")));
  EXPECT_THAT(run.err, AllOf(HasSubstr("solve        "), Not(HasSubstr("(as before)"))));
  EXPECT_THAT(Flair({"jobs"}).out, HasSubstr("(replay of " + job + ")\n"));
}

TEST_F(ReplayCommand, FromAStageTakesTheRest) {
  const std::string job = Design();
  const Finished run = Replay(job, {"--from", "solve", "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const json all = LastLine(run.out);
  EXPECT_EQ(all["agrees"], true) << all;
  EXPECT_EQ(all["stages"][8]["verdict"], "taken");
  EXPECT_EQ(all["stages"][9]["verdict"], "agrees");
  const Finished shown = Flair({"jobs", "show", all["replay_job_id"]});
  EXPECT_THAT(shown.out, HasSubstr("replay of  " + job + " from solve\n"));
  // A replay can be replayed, and what it took be taken again.
  EXPECT_EQ(Replay(all["replay_job_id"], {"--from", "render", "--quiet"}).exit_code, 0);
}

TEST_F(ReplayCommand, OtherOptionsDifferAsAsked) {
  const std::string job = Design();
  const Finished run =
      Replay(job, {"--set", "optimizer.seed=8", "--set", "renderer.size=512", "--out", folder_ / "new"});
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_THAT(run.out,
              AllOf(HasSubstr("translation  taken\n"), HasSubstr("solve        differs as asked  solved_layout.")));
  EXPECT_NE(ReadAll(folder_ / "new" / "layout.pb"), ReadAll(folder_ / "out" / "layout.pb"));
  EXPECT_EQ(ReadAll(folder_ / "new" / "graph.pb"), ReadAll(folder_ / "out" / "graph.pb"));
  const Finished threads = Replay(job, {"--set", "optimizer.threads=1"});
  EXPECT_EQ(threads.exit_code, 0);
  EXPECT_THAT(threads.out, HasSubstr("solve        agrees\n"));
  const Finished seed = Replay(job, {"--set", "brief.seed=8"});
  EXPECT_EQ(seed.exit_code, 0) << seed.out << seed.err;
  EXPECT_THAT(seed.out, HasSubstr("brief        differs as asked  brief.seed: 7 -> 8\n"));
}

TEST_F(ReplayCommand, SaysWhereTheJobsPartAndEndsWithSeven) {
  const std::string job = Design();
  MoveFirstObjectIn(job);
  const Finished run = Replay(job, {"--from", "solve"});
  EXPECT_EQ(run.exit_code, 7) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("solve        differs           solved_layout.placements[0].x_m: 1.25 -> "),
                             HasSubstr("1 differs, first \"solve\"; by the same program, build and configuration")));
  EXPECT_THAT(run.err, Not(HasSubstr("flair:")));
}

TEST_F(ReplayCommand, AKilledReplayGoesOn) {
  const std::string job = Design();
  {
    Process process(ProgramPath("flair"), {"replay", job, "--from", "objects", "--json"},
                    {{"FLAIR_HOME", folder_ / "home"}});
    for (int i = 0; i < 6; ++i) process.WaitForLine("{");
    process.Signal(SIGKILL);
    process.Wait();
  }
  const Finished again = Replay(job, {"--from", "objects"});
  EXPECT_EQ(again.exit_code, 0) << again.out << again.err;
  EXPECT_THAT(again.err, HasSubstr("which was interrupted"));
  EXPECT_THAT(again.out, HasSubstr("3 taken\n"));
  EXPECT_THAT(Replay(job, {"--from", "objects"}).err, Not(HasSubstr("which was interrupted")));
}

TEST_F(ReplayCommand, ServesJobsOfAnOrchestratorElsewhere) {
  AllPrograms programs(folder_.path());
  ASSERT_NE(programs.orchestrator(), "");
  const std::string job = Design({"--orchestrator", programs.orchestrator()});
  const Finished run = Replay(job, {"--orchestrator", programs.orchestrator(), "--from", "translation"});
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_THAT(run.out, HasSubstr("4 stages agree, 8 taken\n"));
  EXPECT_EQ(Replay(job).exit_code, 2);  // not in the own store
}

TEST_F(ReplayCommand, AnotherBuildThatDoesTheSameIsCalledOut) {
  const std::string job = Design();
  const ServerProgram other("../test_bin/flair_other_optimizer",
                            "runtime { listen_address: \"127.0.0.1:0\" log_level: \"error\" }\n", folder_.path());
  const Finished run = Replay(job, {"--from", "solve", "--optimizer", other.address()});
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("solve        same content\n"),
                             HasSubstr("producer.build: \"" + BuildOfFlair() + "\" -> \"another-build\"\n")));
}

TEST_F(ReplayCommand, SaysWhichArtifactIsDamagedOrGone) {
  const std::string job = Design();
  const std::string objects = json::parse(ReadAll(folder_ / "out" / "objects.json"))["id"];
  const auto artifacts = *orchestrator::LocalArtifacts::Open(folder_ / "home" / "artifacts");
  orchestrator::SealedArtifact sealed;
  sealed.ref.set_id(objects);
  sealed.bytes = "damaged";
  ASSERT_TRUE(artifacts->PutAll(std::span(&sealed, 1)).ok());
  const Finished damaged = Replay(job, {"--from", "solve"});
  EXPECT_EQ(damaged.exit_code, 5) << damaged.err;
  EXPECT_THAT(damaged.err, HasSubstr(objects));
  ASSERT_EQ(*artifacts->Delete(std::span(&objects, 1), std::numeric_limits<int64_t>::max()), 1);
  const Finished gone = Replay(job, {"--from", "solve"});
  EXPECT_EQ(gone.exit_code, 2) << gone.err;
  EXPECT_THAT(gone.err, HasSubstr("artifact " + objects + ": not in this store"));
}

TEST_F(ReplayCommand, RefusesWhatMakesNoSense) {
  const std::string job = Design();
  const struct {
    std::vector<std::string> arguments;
    const char* error;
  } cases[] = {
      {{"nothing"}, "nothing: no such job in the store "},
      {{job, "--from", "sole"}, "--from sole: no such stage; expected one of brief, room"},
      {{job, "--set", "optimizer.restart=5"}, "no such option; expected one of optimizer.seed, optimizer.restarts"},
      {{job, "--set", "optimizer.restarts=0"}, "--set optimizer.max_restart_count: 0 is outside [1, 10000]"},
      {{job, "--set", "optimizer.restarts=5", "--from", "render"}, "would be taken from the earlier job; --from solve"},
      {{job, "--set", "brief.seed=5", "--from", "room"}, "would be taken from the earlier job; --from brief"},
  };
  for (const auto& bad : cases) {
    std::vector<std::string> arguments = {"replay"};
    arguments.insert(arguments.end(), bad.arguments.begin(), bad.arguments.end());
    const Finished run = Flair(arguments);
    EXPECT_EQ(run.exit_code, 2) << bad.error;
    EXPECT_THAT(run.err, HasSubstr(bad.error));
    EXPECT_EQ(run.out, "");
  }
}

}  // namespace
}  // namespace flair::testing
