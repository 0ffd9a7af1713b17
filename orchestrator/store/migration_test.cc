// SPDX-License-Identifier: GPL-3.0-or-later
// Stores of earlier versions go on: their jobs, what can be used again, and what is deleted with whom.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sqlite3.h>

#include <filesystem>
#include <fstream>

#include "absl/strings/escaping.h"
#include "orchestrator/store/artifact_id.h"
#include "orchestrator/store/local_artifacts.h"
#include "orchestrator/store/sqlite_work_queue.h"
#include "orchestrator/testing/temporary_folder.h"
#include "worker_runtime/files/files.h"

namespace flair::orchestrator {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;

v1::JobSpec SpecOfBrief(const std::string& text) {
  v1::JobSpec spec;
  spec.mutable_brief()->set_text(text);
  return spec;
}

std::string KeyOfText(const std::string& text) { return runtime::Sha256Hex("key of " + text); }

class StoreOfVersion3 : public ::testing::Test {
 protected:
  StoreOfVersion3() {
    EXPECT_EQ(sqlite3_open((folder_.path() + "/jobs.db").c_str(), &connection_), SQLITE_OK);
    for (const char* step : {"schema", "migration_2", "migration_3"}) {
      std::ifstream file(std::string(FLAIR_SOURCE_DIR "/orchestrator/store/") + step + ".sql");
      Execute(std::string(std::istreambuf_iterator<char>(file), {}));
    }
    Execute("PRAGMA user_version = 3; PRAGMA journal_mode = WAL");
  }
  ~StoreOfVersion3() override { sqlite3_close(connection_); }

  void Execute(const std::string& sql) {
    char* error = nullptr;
    EXPECT_EQ(sqlite3_exec(connection_, sql.c_str(), nullptr, nullptr, &error), SQLITE_OK) << error;
  }

  // A job that ended, as version 3 kept it.
  void AddJob(const std::string& id, const std::string& brief, const std::string& caller = "") {
    const std::string spec = absl::BytesToHexString(SpecOfBrief(brief).SerializeAsString());
    Execute(
        fmt::format("INSERT INTO jobs (id, spec, state, create_time_us, end_time_us, caller) "
                    "VALUES ('{}', x'{}', 3, 1, 2, '{}')",
                    id, spec, caller));
  }
  // One of its artifacts, found again under KeyOfText.
  std::string AddArtifact(const std::string& job, int stage, const std::string& text) {
    v1::Artifact artifact;
    artifact.mutable_brief()->set_text(text);
    const std::string artifact_id = artifacts_->Put(artifact)->id();
    Execute(fmt::format("INSERT INTO job_artifacts VALUES ('{}', {}, '{}', 1, 7)", job, stage, artifact_id));
    Execute(fmt::format("INSERT OR REPLACE INTO results VALUES ('{}', '{}', 1, 7)", KeyOfText(text), artifact_id));
    return artifact_id;
  }

  std::unique_ptr<WorkQueue> OpenNow() { return *SqliteWorkQueue::Open(folder_.path(), runtime::SystemClock()); }

  bool IsFound(WorkQueue& queue, const std::string& text) { return queue.FindResult(KeyOfText(text))->has_value(); }

  TemporaryFolder folder_;
  sqlite3* connection_ = nullptr;
  std::unique_ptr<LocalArtifacts> artifacts_ = *LocalArtifacts::Open(folder_.path() + "/artifacts");
};

TEST_F(StoreOfVersion3, IsListedAndUsedAgain) {
  AddJob("j1", "A bedroom.", "ada");
  AddJob("j2", "A kitchen.");
  const std::string room = AddArtifact("j1", 0, "room");
  AddArtifact("j2", 0, "kitchen");
  const auto queue = OpenNow();
  const auto jobs = queue->ListJobs({});
  ASSERT_TRUE(jobs.ok()) << jobs.status();
  ASSERT_EQ(jobs->size(), 2u);
  ASSERT_EQ(jobs->back().artifacts_size(), 1);
  EXPECT_EQ(jobs->back().artifacts(0).id(), room);
  EXPECT_EQ(jobs->back().artifacts(0).size_bytes(), 7);
  EXPECT_EQ((*queue->FindResult(KeyOfText("room")))->id(), room);
  EXPECT_TRUE(IsFound(*queue, "kitchen"));
  EXPECT_TRUE(*queue->OwnsArtifact("ada", room));
  EXPECT_FALSE(*queue->OwnsArtifact("bob", room));
}

TEST_F(StoreOfVersion3, GivesUpWhatNoJobHasAnyMore) {
  AddJob("j1", "A bedroom.");
  AddJob("j2", "A bedroom.");
  const std::string shared = AddArtifact("j1", 0, "shared");
  AddArtifact("j2", 0, "shared");
  const std::string own = AddArtifact("j1", 1, "own");
  const auto queue = OpenNow();
  EXPECT_EQ(queue->DeleteJob("j1", *artifacts_)->artifact_count, 1);
  EXPECT_FALSE(artifacts_->Get(own).ok());
  EXPECT_FALSE(IsFound(*queue, "own"));
  EXPECT_TRUE(artifacts_->Get(shared).ok());
  EXPECT_TRUE(IsFound(*queue, "shared"));
  EXPECT_EQ(queue->DeleteJob("j2", *artifacts_)->artifact_count, 1);
  EXPECT_FALSE(artifacts_->Get(shared).ok());
  EXPECT_FALSE(IsFound(*queue, "shared"));
}

TEST_F(StoreOfVersion3, KeepsWhatAJobOfNowUsesAgain) {
  AddJob("j1", "A bedroom.");
  const std::string shared = AddArtifact("j1", 0, "shared");
  const auto queue = OpenNow();
  v1::Job job;
  job.set_id("j2");
  *job.mutable_spec() = SpecOfBrief("A bedroom.");
  ASSERT_TRUE(queue->CreateJob(job, "r2").ok());
  {
    const auto lease = *queue->Take({});
    ASSERT_NE(lease, nullptr);
    StageRecord reused;
    reused.event.set_job_id("j2");
    reused.event.set_kind(v1::JOB_EVENT_KIND_STAGE_REUSED);
    reused.event.mutable_artifact()->set_id(shared);
    ASSERT_TRUE(lease->Record(reused).ok());
    ASSERT_TRUE(lease->End({.time = absl::Now()}).ok());
  }
  EXPECT_EQ(queue->DeleteJob("j1", *artifacts_)->artifact_count, 0);
  EXPECT_TRUE(artifacts_->Get(shared).ok());
  EXPECT_TRUE(IsFound(*queue, "shared"));
  EXPECT_EQ(queue->DeleteJob("j2", *artifacts_)->artifact_count, 1);
  EXPECT_FALSE(artifacts_->Get(shared).ok());
}

TEST_F(StoreOfVersion3, EndsADeletionThatWaited) {
  AddJob("j1", "A bedroom.");
  const std::string gone = AddArtifact("j1", 0, "gone");
  Execute("DELETE FROM job_artifacts; DELETE FROM results; DELETE FROM jobs");
  Execute(fmt::format("INSERT INTO deleted_artifacts (artifact_id, pending) VALUES ('{}', 1)", gone));
  const auto queue = OpenNow();
  EXPECT_EQ(queue->FinishDeletions(*artifacts_)->artifact_count, 1);
  EXPECT_FALSE(artifacts_->Get(gone).ok());
}

// See tests/fixtures/stores/paused_batch_4273379/README.md.
class PausedBatchOfVersion4 : public ::testing::Test {
 protected:
  PausedBatchOfVersion4() {
    std::filesystem::copy(FLAIR_SOURCE_DIR "/tests/fixtures/stores/paused_batch_4273379/home", folder_.path(),
                          std::filesystem::copy_options::recursive);
  }

  TemporaryFolder folder_;
};

TEST_F(PausedBatchOfVersion4, GoesOnToItsEndWithAllArtifacts) {
  const auto queue = *SqliteWorkQueue::Open(folder_.path(), runtime::SystemClock());
  const auto artifacts = *LocalArtifacts::Open(folder_.path() + "/artifacts");
  const std::string batch_id = queue->ListBatches({})->at(0).id();
  EXPECT_EQ(queue->GetBatch(batch_id)->state(), v1::BATCH_STATE_PAUSED);
  EXPECT_EQ(*queue->Take({}), nullptr);
  int artifact_count = 0;
  const std::vector<v1::Job> done = *queue->ListJobs({.batch_id = batch_id, .state = v1::JOB_STATE_SUCCEEDED});
  EXPECT_EQ(done.size(), 2u);
  for (const v1::Job& job : done) {
    for (const v1::ArtifactRef& ref : job.artifacts()) {
      const absl::StatusOr<v1::Artifact> artifact = artifacts->Get(ref.id());
      ASSERT_TRUE(artifact.ok()) << artifact.status();
      EXPECT_EQ(KindOf(*artifact), ref.kind());
      ++artifact_count;
    }
    EXPECT_FALSE(queue->EventsAfter(job.id(), 0, 100)->empty());
  }
  EXPECT_EQ(artifact_count, 22);

  ASSERT_TRUE(queue->SetBatchState(batch_id, v1::BATCH_STATE_ACTIVE).ok());
  std::vector<std::string> ended;
  while (const auto lease = *queue->Take({})) {
    ended.push_back(lease->job().id());
    ASSERT_TRUE(lease->End({.time = absl::Now()}).ok());
  }
  EXPECT_THAT(ended,
              ElementsAre(EndsWith("-00000002"), EndsWith("-00000003"), EndsWith("-00000004"), EndsWith("-00000005")));
  EXPECT_TRUE(*queue->BatchHasEnded(batch_id));
  EXPECT_EQ(queue->EndsAfter(batch_id, 0, 100)->size(), 6u);
}

TEST_F(PausedBatchOfVersion4, KeepsItsResultsForReuseUntilItsJobsAreDeleted) {
  const auto queue = *SqliteWorkQueue::Open(folder_.path(), runtime::SystemClock());
  const auto artifacts = *LocalArtifacts::Open(folder_.path() + "/artifacts");
  const auto store = *JobStore::Open(folder_.path());
  const std::vector<std::string> keys = *store->database().Texts("SELECT key FROM results");
  EXPECT_EQ(keys.size(), 22u);
  for (const std::string& key : keys) {
    const auto ref = queue->FindResult(key);
    ASSERT_TRUE(ref.ok() && ref->has_value()) << key;
    EXPECT_TRUE(artifacts->Get((*ref)->id()).ok());
  }
  const std::string batch_id = queue->ListBatches({})->at(0).id();
  ASSERT_TRUE(queue->CancelBatch(batch_id, absl::Now()).ok());
  const absl::StatusOr<Deleted> deleted = queue->DeleteBatch(batch_id, 100, *artifacts);
  ASSERT_TRUE(deleted.ok()) << deleted.status();
  EXPECT_EQ(deleted->artifact_count, 22);
  EXPECT_EQ(*store->database().FirstInt("SELECT count(*) FROM results"), 0);
}

}  // namespace
}  // namespace flair::orchestrator
