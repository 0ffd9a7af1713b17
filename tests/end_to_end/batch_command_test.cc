// SPDX-License-Identifier: GPL-3.0-or-later
// flair batch with real stores and servers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <map>
#include <thread>

#include "nlohmann/json.hpp"
#include "tests/fixtures/programs.h"
#include "worker_runtime/files/files.h"

namespace flair::testing {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

// Two lines with one brief, so that something can be used again, and none that takes long.
constexpr char kBriefs[] =
    "A bedroom that is 3m x 4m.\n"
    "{\"id\": \"b\", \"text\": \"A small study.\", \"seed\": 3}\n"
    "A bedroom that is 3m x 4m.\n"
    "{\"id\": \"d\", \"text\": \"A bathroom.\", \"variants\": 2}\n"
    "A small study with a desk.\n"
    "A bedroom for a child.\n";
constexpr int kBriefCount = 6;

json LastLine(const std::string& out) {
  if (out.size() < 2) return {};
  return json::parse(out.substr(out.rfind('\n', out.size() - 2) + 1), nullptr, false);
}

class BatchCommand : public ::testing::Test {
 protected:
  BatchCommand() { WriteAll(folder_ / "briefs.jsonl", kBriefs); }

  std::vector<std::string> Submission(const std::string& out, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"batch", folder_ / "briefs.jsonl", "--out",      folder_ / out,
                                          "--set", "optimizer.restarts=2",   "--size",     "256",
                                          "--set", "renderer.layers=zones",  "--parallel", "2"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  Finished Flair(const std::vector<std::string>& arguments, const std::string& home = "home") const {
    return RunProgram("flair", arguments, {{"FLAIR_HOME", folder_ / home}});
  }
  Finished Batch(const std::vector<std::string>& arguments) const {
    std::vector<std::string> all = {"batch"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return Flair(all);
  }
  // Digests of the layouts of all jobs in a folder, by their places.
  std::map<std::string, std::string> Layouts(const std::string& out) const {
    std::map<std::string, std::string> layouts;
    std::error_code error;
    // A batch that runs renames folders meanwhile, at which the walk ends early.
    for (fs::recursive_directory_iterator entry(folder_ / out / "jobs", error), end; entry != end;
         entry.increment(error)) {
      const fs::path& path = entry->path();
      if (path.filename() == "layout.pb") {
        layouts[path.parent_path().filename()] = runtime::Sha256Hex(ReadAll(path));
      }
    }
    return layouts;
  }
  std::map<std::string, std::string> UndisturbedLayouts() const {
    const Finished run = Flair(Submission("undisturbed", {"--quiet"}), "another_home");
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return Layouts("undisturbed");
  }
  // Waits until a job has a folder; the process is running as long as it has not.
  void WaitForAJob(Process& process, const std::string& out) const {
    // With pauses: the batch needs the processors.
    while (Layouts(out).empty() && process.Running()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }

  TestFolder folder_;
};

TEST_F(BatchCommand, EveryLineBecomesAFolderAndARow) {
  const Finished run = Flair(Submission("out"));
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, AllOf(StartsWith("batch 2"), HasSubstr("6 jobs: 6 succeeded\n"), Not(HasSubstr("flair:"))));
  EXPECT_EQ(Layouts("out").size(), 6u);
  const fs::path job = folder_ / "out/jobs/000/000003";
  EXPECT_THAT(ReadAll(job / "plan.png"), StartsWith("\x89PNG"));
  EXPECT_EQ(json::parse(ReadAll(job / "job.json"))["spec"]["solve_options"]["variant_count"], 2);
  EXPECT_TRUE(json::parse(ReadAll(job / "report.json"))["report"].contains("metrics"));
  EXPECT_EQ(Layouts("out")["000000"], Layouts("out")["000002"]);

  EXPECT_EQ(Batch({"report", folder_ / "out", "--csv", folder_ / "a.csv"}).exit_code, 0);
  const std::string csv = ReadAll(folder_ / "a.csv");
  EXPECT_THAT(csv, AllOf(HasSubstr("\r\n1,2,b,"), HasSubstr(",succeeded,,,,,1,3,A small study.,")));
  EXPECT_EQ(std::ranges::count(csv, '\n'), kBriefCount + 1);
  // Of its id, the same is told by the orchestrator.
  const json of_folder = json::parse(Batch({"report", folder_ / "out", "--json"}).out);
  const json of_id = json::parse(Batch({"report", of_folder["batch_id"], "--json"}).out);
  for (const char* field : {"succeeded_count", "satisfied_count", "first_time", "last_time", "columns"}) {
    EXPECT_EQ(of_id[field], of_folder[field]) << field;
  }
}

TEST_F(BatchCommand, TheSameFileIsTheSameBatchAndAnotherNameAnother) {
  ASSERT_EQ(Flair(Submission("out", {"--keep", "none"})).exit_code, 0);
  const Finished again = Flair(Submission("elsewhere"));
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(again.err, HasSubstr("which exists and continues\n"));
  EXPECT_EQ(Layouts("elsewhere").size(), 6u);
  EXPECT_EQ(Flair(Submission("third", {"--name", "again", "--keep", "none"})).exit_code, 0);
  const std::string list = Batch({"list"}).out;
  EXPECT_EQ(std::ranges::count(list, '\n'), 2) << list;
  EXPECT_THAT(list, AllOf(HasSubstr("  6/6  "), HasSubstr("  again\n"), HasSubstr("  briefs.jsonl\n")));
}

TEST_F(BatchCommand, BadLinesAreToldAndTheExitCodeSaysSo) {
  WriteAll(folder_ / "briefs.jsonl",
           "A bathroom.\n{\"txt\": \"A room.\"}\n\n{\"text\": \"A room.\", \"variants\": 0}\n");
  const Finished run = Flair(Submission("out"));
  EXPECT_EQ(run.exit_code, 9);
  EXPECT_THAT(run.err, AllOf(HasSubstr("1 job: 1 succeeded; 2 lines rejected"), HasSubstr("2 lines were rejected; ")));
  const std::string rejected = ReadAll(folder_ / "out/rejected.jsonl");
  EXPECT_THAT(rejected, AllOf(HasSubstr("\"line\":2,"), HasSubstr("did you mean text?"), HasSubstr("\"line\":4,")));
}

TEST_F(BatchCommand, AKilledOneGoesOnToTheSameBytes) {
  {
    Process process(ProgramPath("flair"), Submission("out"), {{"FLAIR_HOME", folder_ / "home"}});
    WaitForAJob(process, "out");
    process.Signal(SIGKILL);
    process.Wait();
  }
  EXPECT_FALSE(Layouts("out").empty());
  const Finished again = Flair(Submission("out"));
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(Layouts("out"), UndisturbedLayouts());
}

TEST_F(BatchCommand, AnInterruptedOneSaysHowItGoesOn) {
  {
    Process process(ProgramPath("flair"), Submission("out"), {{"FLAIR_HOME", folder_ / "home"}});
    WaitForAJob(process, "out");
    process.Signal(SIGINT);
    const Finished stopped = process.Wait();
    EXPECT_EQ(stopped.exit_code, 130);
    EXPECT_THAT(stopped.err, HasSubstr("continues where it was: give the same command again"));
  }
  const Finished on = Batch({"watch", folder_ / "out", "--parallel", "2"});
  EXPECT_EQ(on.exit_code, 0) << on.err;
  EXPECT_EQ(Layouts("out").size(), 6u);
}

TEST_F(BatchCommand, ShardsHoldWhatFoldersHold) {
  const Finished run = Flair(Submission("out", {"--shards", "4", "--keep", "layout"}));
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const json index = json::parse(ReadAll(folder_ / "out/shards/index.json"));
  ASSERT_EQ(index["shardlist"].size(), 2u);
  EXPECT_EQ(index["shardlist"][0]["nsamples"], 4);
  std::string tars =
      ReadAll(folder_ / "out/shards/shard-000000.tar") + ReadAll(folder_ / "out/shards/shard-000001.tar");
  for (const auto& [job, digest] : UndisturbedLayouts()) {
    const std::string layout = ReadAll(folder_ / "undisturbed/jobs/000" / job / "layout.pb");
    EXPECT_NE(tars.find(job + ".layout.pb"), std::string::npos) << job;
    EXPECT_NE(tars.find(layout), std::string::npos) << job;
  }
}

TEST_F(BatchCommand, WaitsWhilePausedAndEndsWhenCancelled) {
  std::vector<std::string> arguments = Submission("out", {"--submit-only"});
  ASSERT_EQ(Flair(arguments).exit_code, 0);
  EXPECT_THAT(Batch({"pause", folder_ / "out"}).out, HasSubstr("state      paused\n"));
  EXPECT_EQ(json::parse(Batch({"status", folder_ / "out", "--json"}).out)["open_count"], 6);
  EXPECT_THAT(Batch({"resume", folder_ / "out"}).out, HasSubstr("state      active\n"));
  EXPECT_THAT(Batch({"cancel", folder_ / "out"}).out, HasSubstr("cancelled  6\n"));
  const Finished watch = Batch({"watch", folder_ / "out"});
  EXPECT_EQ(watch.exit_code, 10);
  EXPECT_THAT(watch.err, HasSubstr("6 jobs: 0 succeeded, 6 cancelled"));
  EXPECT_EQ(Batch({"resume", folder_ / "out"}).exit_code, 10);
  const Finished again = Flair(Submission("out"));
  EXPECT_EQ(again.exit_code, 10);
  EXPECT_THAT(again.err, HasSubstr("which was cancelled; to run them anyway, give another --name"));
}

// See tests/fixtures/stores/paused_batch_4273379/README.md.
TEST_F(BatchCommand, APausedBatchOfAnEarlierStoreGoesOn) {
  const std::string fixture = FLAIR_SOURCE_DIR "/tests/fixtures/stores/paused_batch_4273379";
  fs::copy(fixture + "/home", folder_ / "home", fs::copy_options::recursive);
  const std::string list = Batch({"list"}).out;
  EXPECT_THAT(list, AllOf(HasSubstr("  paused     2/6  "), HasSubstr("  paused\n")));
  EXPECT_EQ(Batch({"resume", list.substr(0, list.find(' '))}).exit_code, 0);
  const Finished run =
      Flair({"batch", fixture + "/briefs.jsonl", "--out", folder_ / "out", "--set", "optimizer.restarts=1", "--size",
             "256", "--name", "paused", "--keep", "brief,room,layout,pictures,report"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, AllOf(HasSubstr("which exists and continues\n"), HasSubstr("6 jobs: 6 succeeded\n")));
  EXPECT_EQ(Layouts("out").size(), 6u);
}

TEST_F(BatchCommand, FailedJobsAreToldByKindAndRunAgainWhenAsked) {
  WriteAll(folder_ / "briefs.jsonl", "A bathroom.\n");
  fs::create_directories(folder_ / "answers");  // of a model that has none
  WriteAll(folder_ / "answers/identity", "a model\n");
  const Finished run = Flair(Submission("out", {"--replay", folder_ / "answers"}));
  EXPECT_EQ(run.exit_code, 9) << run.err;
  EXPECT_THAT(run.err, AllOf(HasSubstr("1 job: 0 succeeded, 1 failed\n      1 language, such as job 0 (line 1): room:"),
                             HasSubstr("flair batch retry ")));
  EXPECT_THAT(Batch({"retry", "--kind", "worker", folder_ / "out"}).out, HasSubstr("0 jobs wait again"));
  EXPECT_THAT(Batch({"retry", folder_ / "out", "--job", "0"}).out, HasSubstr("1 job waits again; "));
  const Finished watch = Batch({"watch", folder_ / "out"});  // with the handbook
  EXPECT_EQ(watch.exit_code, 0) << watch.err;
  EXPECT_EQ(Layouts("out").size(), 1u);
  EXPECT_THAT(Batch({"report", folder_ / "out"}).out, HasSubstr("1 job: 1 succeeded\n"));
}

TEST_F(BatchCommand, AnOrchestratorElsewhereGivesTheSameBytesToWhoeverCollects) {
  const AllPrograms programs(folder_.path());
  ASSERT_NE(programs.orchestrator(), "");
  std::vector<std::string> arguments = {"batch",
                                        folder_ / "briefs.jsonl",
                                        "--out",
                                        folder_ / "out",
                                        "--set",
                                        "optimizer.restarts=2",
                                        "--size",
                                        "256",
                                        "--set",
                                        "renderer.layers=zones",
                                        "--json",
                                        "--orchestrator",
                                        programs.orchestrator()};
  const Finished run = Flair(arguments, "no_home");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const std::string id = LastLine(run.out)["batch_id"];
  EXPECT_EQ(Layouts("out"), UndisturbedLayouts());
  const Finished watch = Batch({"watch", id.substr(0, id.size() - 2), "--out", folder_ / "other", "--keep", "layout",
                                "--orchestrator", programs.orchestrator()});
  EXPECT_EQ(watch.exit_code, 0) << watch.err;
  EXPECT_EQ(Layouts("other"), Layouts("out"));
  EXPECT_FALSE(fs::exists(folder_ / "other/jobs/000/000000/plan.png"));
}

struct Wrong {
  const char* name;
  std::vector<std::string> arguments;
  int exit_code;
  const char* words;
};

class WrongBatchCommand : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongBatchCommand, SaysWhatWouldBeRight) {
  const TestFolder folder;
  WriteAll(folder / "briefs", "A bathroom.\n");
  std::vector<std::string> arguments = GetParam().arguments;
  for (std::string& argument : arguments) {
    if (argument.starts_with("@")) argument = folder / argument.substr(1);
  }
  const Finished run = RunProgram("flair", arguments, {{"FLAIR_HOME", folder / "home"}});
  EXPECT_EQ(run.exit_code, GetParam().exit_code) << run.err;
  EXPECT_THAT(run.err, HasSubstr(GetParam().words));
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongBatchCommand,
    ::testing::Values(
        Wrong{
            "NoFile", {"batch", "@none", "--out", "@out"}, 2, "no such file; expected a file with one brief per line"},
        Wrong{"Folder", {"batch", "@.", "--out", "@out"}, 4, "is a folder"},
        Wrong{"NoOut", {"batch", "@briefs"}, 2, "--out: missing"},
        Wrong{"OutIsAFile", {"batch", "@briefs", "--out", "@briefs"}, 4, "is a file; --out takes a folder"},
        Wrong{"Keep", {"batch", "@briefs", "--out", "@out", "--keep", "layuot"}, 2, "did you mean layout?"},
        Wrong{"View", {"batch", "@briefs", "--out", "@out", "--view", "top"}, 2, "top"},
        Wrong{"Option", {"batch", "@briefs", "--out", "@out", "--set", "optimizer.restart=3"}, 2, "no such option"},
        Wrong{"Parallel",
              {"batch", "@briefs", "--out", "@out", "--parallel", "2", "--orchestrator", "h:1"},
              2,
              "--parallel 2: not with --orchestrator h:1"},
        Wrong{"TwoPlaces",
              {"batch", "@briefs", "--out", "@out", "--engine", "nats://h:1", "--orchestrator", "h:1"},
              2,
              "--engine: not with --orchestrator h:1"},
        Wrong{"QueueAlone", {"batch", "@briefs", "--out", "@out", "--queue", "q"}, 2, "--queue: belongs to a queue"},
        Wrong{"NobodyThere",
              {"batch", "@briefs", "--out", "@out", "--orchestrator", "127.0.0.1:1"},
              3,
              "no orchestrator answers at 127.0.0.1:1"},
        Wrong{"NoBatch", {"batch", "status", "2026"}, 2, "no batch has an id that begins like this"},
        Wrong{"NoSuchKind", {"batch", "retry", "2026", "--kind", "bad"}, 2, "2026: no batch"},
        Wrong{"NoFolder", {"batch", "watch", "@out"}, 2, "no folder of that name has results.db"}),
    [](const auto& test) { return test.param.name; });

TEST_F(BatchCommand, AFolderIsOfOneBatch) {
  ASSERT_EQ(Flair(Submission("out", {"--submit-only"})).exit_code, 0);
  WriteAll(folder_ / "briefs.jsonl", "A bathroom.\n");
  const Finished other = Flair(Submission("out"));
  EXPECT_EQ(other.exit_code, 4);
  EXPECT_THAT(other.err, HasSubstr("of other briefs or options; give --out another folder"));
}

}  // namespace
}  // namespace flair::testing
