// SPDX-License-Identifier: GPL-3.0-or-later
// Kills a real process with SIGKILL while it runs jobs, again and again, and looks at what is in the store at the end.
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <map>
#include <string>

#include "orchestrator/store/job_store.h"
#include "orchestrator/store/local_artifacts.h"
#include "orchestrator/testing/temporary_folder.h"

namespace flair::orchestrator {
namespace {

constexpr int kJobCount = 12;
constexpr int kReplayCount = kJobCount / 3;  // see crash_test_child.cc
constexpr size_t kAllCount = kJobCount + kReplayCount + 1;

// A running child; its standard output is read line by line.
class Child {
 public:
  explicit Child(const std::string& store) {
    int ends[2];
    if (::pipe(ends) != 0) std::abort();
    pid_ = ::fork();
    if (pid_ == 0) {
      ::dup2(ends[1], STDOUT_FILENO);
      ::close(ends[0]);
      ::close(ends[1]);
      const std::string program = FLAIR_BINARY_DIR "/test_bin/orchestrator_crash_test_child";
      ::execl(program.c_str(), program.c_str(), store.c_str(), std::to_string(kJobCount).c_str(), nullptr);
      ::_exit(127);
    }
    ::close(ends[1]);
    output_ = ::fdopen(ends[0], "r");
  }
  ~Child() { std::fclose(output_); }

  // False at the end of the output.
  bool ReadLine(std::string& line) {
    char buffer[256];
    if (std::fgets(buffer, sizeof buffer, output_) == nullptr) return false;
    line = buffer;
    return true;
  }
  void Kill() { ::kill(pid_, SIGKILL); }
  int Wait() {
    int status = 0;
    ::waitpid(pid_, &status, 0);
    return status;
  }

 private:
  pid_t pid_;
  std::FILE* output_;
};

// Runs a child and kills it at its n-th call of a stage; true when it got done before.
bool RunAndKillAt(const std::string& store, int call) {
  Child child(store);
  std::string line;
  for (int i = 0; child.ReadLine(line); ++i) {
    if (line == "done\n") {
      EXPECT_EQ(child.Wait(), 0);
      return true;
    }
    if (i == call) child.Kill();
  }
  child.Wait();
  return false;
}

std::string NameOf(const v1::Job& job) { return job.spec().brief().text() + (job.spec().has_replay() ? " again" : ""); }

// The artifacts but the report of every job, by its name.
std::map<std::string, std::vector<std::string>> ReadArtifacts(const std::string& path) {
  auto store = *JobStore::Open(path);
  const auto artifacts_of = *LocalArtifacts::Open(path + "/artifacts");
  std::map<std::string, std::vector<std::string>> artifacts;
  const std::vector<v1::Job> jobs = *store->jobs().List({.limit = 1000});
  for (const v1::Job& job : jobs) {
    std::vector<std::string>& ids = artifacts[NameOf(job)];
    EXPECT_TRUE(ids.empty()) << "two jobs for " << NameOf(job);
    EXPECT_EQ(job.state(), v1::JOB_STATE_SUCCEEDED) << job.error();
    EXPECT_EQ(job.artifacts_size(), job.batch_id().empty() ? 3 : 12) << "one was given its layout";
    for (const v1::ArtifactRef& ref : job.artifacts()) {
      EXPECT_TRUE(artifacts_of->Get(ref.id()).ok());
      if (ref.kind() != v1::ARTIFACT_KIND_REPORT) ids.push_back(ref.id());
    }
    int ends = 0;
    const std::vector<v1::JobEvent> events = *store->jobs().EventsAfter(job.id(), 0, 10000);
    for (const v1::JobEvent& event : events) ends += event.kind() == v1::JOB_EVENT_KIND_ENDED ? 1 : 0;
    EXPECT_EQ(ends, 1) << job.id();
  }
  return artifacts;
}

TEST(Crash, EveryJobEndsOnceWithTheArtifactsOfAnUndisturbedRun) {
  TemporaryFolder undisturbed;
  ASSERT_TRUE(RunAndKillAt(undisturbed.path(), -1));
  TemporaryFolder disturbed;
  int kills = 0;
  // Each child comes a little further than a whole job before it dies; the early ones die in their first job.
  for (int call = 0; !RunAndKillAt(disturbed.path(), call); call = (call + 5) % 23) {
    ASSERT_LT(++kills, 100) << "no progress";
  }
  EXPECT_GE(kills, 3);
  const auto expected = ReadArtifacts(undisturbed.path());
  EXPECT_EQ(expected.size(), kAllCount);
  EXPECT_EQ(ReadArtifacts(disturbed.path()), expected);
}

// Of its own stages, each once: what it had before it was killed was not made twice, nor was another job's used.
void ExpectEachStageRunOnce(JobStore& store, const v1::Job& replay) {
  std::map<std::string, int> finished;
  const std::vector<v1::JobEvent> events = *store.jobs().EventsAfter(replay.id(), 0, 10000);
  for (const v1::JobEvent& event : events) {
    finished[event.stage()] += event.kind() == v1::JOB_EVENT_KIND_STAGE_FINISHED ? 1 : 0;
  }
  for (const char* stage : {"brief", "room", "zones"}) EXPECT_EQ(finished[stage], 0) << replay.id() << " " << stage;
  for (const char* stage :
       {"objects", "style", "constraints", "cleaning", "completion", "translation", "solve", "render", "report"}) {
    EXPECT_EQ(finished[stage], 1) << replay.id() << " " << stage;
  }
}

TEST(Crash, KilledReplaysGoOnFromTheirOwnArtifacts) {
  TemporaryFolder folder;
  ASSERT_TRUE(RunAndKillAt(folder.path(), -1));
  const auto expected = ReadArtifacts(folder.path());
  TemporaryFolder disturbed;
  int kills = 0;
  constexpr int kCallsOfTheBatch = kJobCount * 11;
  for (int call = kCallsOfTheBatch + 2; !RunAndKillAt(disturbed.path(), call); call = 4 + kills % 7) {
    ASSERT_LT(++kills, 100) << "no progress";
  }
  EXPECT_GE(kills, 2);
  EXPECT_EQ(ReadArtifacts(disturbed.path()), expected);
  auto store = *JobStore::Open(disturbed.path());
  int replays = 0;
  const std::vector<v1::Job> jobs = *store->jobs().List({.limit = 1000});
  for (const v1::Job& job : jobs) {
    if (!job.spec().has_replay()) continue;
    ++replays;
    ExpectEachStageRunOnce(*store, job);
  }
  EXPECT_EQ(replays, kReplayCount);
}

TEST(Crash, AnotherProcessTakesOverTheJobsOfADeadOne) {
  TemporaryFolder folder;
  Child first(folder.path());
  std::string line;
  ASSERT_TRUE(first.ReadLine(line));
  Child second(folder.path());
  ASSERT_TRUE(second.ReadLine(line));
  first.Kill();
  first.Wait();
  while (line != "done\n") ASSERT_TRUE(second.ReadLine(line));
  EXPECT_EQ(second.Wait(), 0);
  EXPECT_EQ(ReadArtifacts(folder.path()).size(), kAllCount);
}

}  // namespace
}  // namespace flair::orchestrator
