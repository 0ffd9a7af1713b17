// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <sqlite3.h>

#include <filesystem>
#include <fstream>
#include <latch>
#include <span>
#include <thread>
#include <vector>

#include "orchestrator/batch/job_rules.h"
#include "orchestrator/store/artifact_id.h"
#include "orchestrator/store/job_store.h"
#include "orchestrator/store/local_artifacts.h"
#include "orchestrator/store/sqlite_work_queue.h"
#include "orchestrator/testing/temporary_folder.h"
#include "worker_runtime/files/files.h"

namespace flair::orchestrator {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

v1::Artifact BriefArtifact(const std::string& text) {
  v1::Artifact artifact;
  artifact.mutable_brief()->set_text(text);
  return artifact;
}

v1::Job NewJob(const std::string& id) {
  v1::Job job;
  job.set_id(id);
  job.mutable_spec()->mutable_brief()->set_text("A bedroom.");
  return job;
}

TEST(Sha256, MatchesThePublishedVectors) {
  EXPECT_EQ(runtime::Sha256Hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(runtime::Sha256Hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(ArtifactId, CoversContentAndOriginButNotItself) {
  v1::Artifact artifact = BriefArtifact("A bedroom.");
  const std::string id = ComputeArtifactId(artifact);
  EXPECT_TRUE(IsArtifactId(id));
  artifact.set_id(id);
  EXPECT_EQ(ComputeArtifactId(artifact), id);
  artifact.add_made_from_ids(id);
  EXPECT_NE(ComputeArtifactId(artifact), id);
  EXPECT_NE(ComputeArtifactId(BriefArtifact("A kitchen.")), id);
}

TEST(ArtifactId, KnowsEveryKind) {
  const google::protobuf::OneofDescriptor* content = v1::Artifact::descriptor()->FindOneofByName("content");
  for (int i = 0; i < content->field_count(); ++i) {
    v1::Artifact artifact;
    artifact.GetReflection()->MutableMessage(&artifact, content->field(i));
    std::string name = v1::ArtifactKind_Name(KindOf(artifact));
    std::string expected = "ARTIFACT_KIND_" + content->field(i)->name();
    for (char& c : expected) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    EXPECT_EQ(name, expected);
  }
}

TEST(ResultKey, DiffersWhenAnyPartDoes) {
  const std::string key = ResultKey("solve", "1", "ab", {"c", "d"});
  EXPECT_EQ(key, ResultKey("solve", "1", "ab", {"c", "d"}));
  EXPECT_NE(key, ResultKey("solve", "1", "ab", {"cd"}));
  EXPECT_NE(key, ResultKey("solve", "1a", "b", {"c", "d"}));
  EXPECT_NE(key, ResultKey("solve", "1", "ab", {"d", "c"}));
}

class ArtifactFilesTest : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  ArtifactFiles files_{folder_.path()};
};

TEST_F(ArtifactFilesTest, ReturnsWhatWasPutUnderItsId) {
  v1::Artifact artifact = BriefArtifact("A bedroom.");
  const v1::ArtifactRef ref = *files_.Put(artifact);
  EXPECT_EQ(ref.id(), artifact.id());
  EXPECT_EQ(ref.kind(), v1::ARTIFACT_KIND_BRIEF);
  EXPECT_EQ(static_cast<uintmax_t>(ref.size_bytes()), std::filesystem::file_size(files_.PathOf(ref.id())));
  EXPECT_THAT(files_.PathOf(ref.id()), HasSubstr("/" + ref.id().substr(0, 2) + "/" + ref.id() + ".pb"));
  EXPECT_EQ(files_.Get(ref.id())->brief().text(), "A bedroom.");
}

TEST_F(ArtifactFilesTest, LeavesNoOtherFilesBehind) {
  v1::Artifact artifact = BriefArtifact("A bedroom.");
  ASSERT_TRUE(files_.Put(artifact).ok());
  ASSERT_TRUE(files_.Put(artifact).ok());
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path()))
    count += entry.is_regular_file();
  EXPECT_EQ(count, 1);
}

TEST_F(ArtifactFilesTest, RefusesWhatIsNoId) {
  for (const std::string id : {"", "abc", "../../../../etc/passwd"}) {
    EXPECT_EQ(files_.Get(id).status().code(), absl::StatusCode::kInvalidArgument);
  }
  EXPECT_EQ(files_.Get(std::string(64, 'a')).status().code(), absl::StatusCode::kNotFound);
}

TEST_F(ArtifactFilesTest, NoticesEveryDamagedByteAndMendsItWhenPutAgain) {
  v1::Artifact artifact = BriefArtifact("A bedroom.");
  const std::string path = files_.PathOf(files_.Put(artifact)->id());
  const auto size = static_cast<std::streamoff>(std::filesystem::file_size(path));
  for (std::streamoff at = 0; at < size; ++at) {
    {
      std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
      file.seekg(at);
      const char changed = static_cast<char>(file.get() ^ 0x21);
      file.seekp(at);
      file.put(changed);
    }
    EXPECT_EQ(files_.Get(artifact.id()).status().code(), absl::StatusCode::kDataLoss) << "byte " << at;
    ASSERT_TRUE(files_.Put(artifact).ok());
    EXPECT_TRUE(files_.Get(artifact.id()).ok());
  }
  std::filesystem::resize_file(path, 0);
  EXPECT_EQ(files_.Get(artifact.id()).status().code(), absl::StatusCode::kDataLoss);
}

class JobStoreTest : public ::testing::Test {
 protected:
  // Lets `change` make something of a stored job.
  template <typename Change>
  void ChangeJob(const std::string& id, const Change& change) {
    store::v1::JobRecord record = *jobs_.Load(id);
    const int stored_events = record.events_size();
    change(record);
    ASSERT_TRUE(jobs_.Save(record, stored_events).ok());
  }
  void Claim(const std::string& id, const std::string& owner) {
    ChangeJob(id, [&](store::v1::JobRecord& record) { BeginRun(record, owner); });
  }

  TemporaryFolder folder_;
  std::unique_ptr<JobStore> store_ = *JobStore::Open(folder_.path());
  JobTable& jobs_ = store_->jobs();
};

TEST_F(JobStoreTest, KeepsJobsWhenClosedAndOpened) {
  ASSERT_TRUE(jobs_.Insert(NewJob("j1"), "r1").ok());
  store_ = nullptr;
  store_ = *JobStore::Open(folder_.path());
  EXPECT_EQ(store_->jobs().Get("j1")->spec().brief().text(), "A bedroom.");
  EXPECT_EQ(store_->jobs().Get("j1")->state(), v1::JOB_STATE_QUEUED);
  EXPECT_EQ(*store_->jobs().FindByRequest("r1"), "j1");
  EXPECT_EQ(*store_->jobs().FindByRequest("r2"), "");
  EXPECT_EQ(store_->jobs().Get("j2").status().code(), absl::StatusCode::kNotFound);
}

TEST_F(JobStoreTest, RefusesASecondJobOfOneRequest) {
  ASSERT_TRUE(jobs_.Insert(NewJob("j1"), "r1").ok());
  EXPECT_EQ(jobs_.Insert(NewJob("j2"), "r1").code(), absl::StatusCode::kAlreadyExists);
  EXPECT_TRUE(jobs_.Insert(NewJob("j3"), "").ok());
  EXPECT_TRUE(jobs_.Insert(NewJob("j4"), "").ok());
}

TEST_F(JobStoreTest, FindsTheOldestThatWaits) {
  ASSERT_TRUE(jobs_.Insert(NewJob("j2"), "").ok());
  ASSERT_TRUE(jobs_.Insert(NewJob("j1"), "").ok());
  EXPECT_EQ(*jobs_.CountQueued(), 2);
  EXPECT_EQ(*jobs_.OldestWaiting("", absl::Now()), "j1");
  Claim("j1", "me");
  EXPECT_EQ(*jobs_.OldestWaiting("", absl::Now()), "j2");
  Claim("j2", "other");
  EXPECT_EQ(*jobs_.OldestWaiting("", absl::Now()), "");
}

TEST_F(JobStoreTest, LoadsARecordAsItWasSaved) {
  ASSERT_TRUE(jobs_.Insert(NewJob("j1"), "").ok());
  StageRecord stage;
  stage.event.set_kind(v1::JOB_EVENT_KIND_STAGE_FINISHED);
  stage.event.set_stage("room");
  stage.event.mutable_artifact()->set_id(std::string(64, 'a'));
  stage.event.mutable_artifact()->set_kind(v1::ARTIFACT_KIND_ROOM);
  stage.stage_index = 3;
  store::v1::JobRecord changed = *jobs_.Load("j1");
  BeginRun(changed, "me");
  AddStageRecords(changed, std::span(&stage, 1));
  ASSERT_TRUE(jobs_.Save(changed, 0).ok());
  EXPECT_EQ(jobs_.Load("j1")->SerializeAsString(), changed.SerializeAsString());
  const int stored_events = changed.events_size();
  ReturnJob(changed, absl::FromUnixSeconds(1'800'000'000), "no worker");
  changed.set_cancel_requested(true);
  ASSERT_TRUE(jobs_.Save(changed, stored_events).ok());
  EXPECT_EQ(jobs_.Load("j1")->SerializeAsString(), changed.SerializeAsString());
  EXPECT_EQ(jobs_.Load("j2").status().code(), absl::StatusCode::kNotFound);
}

TEST_F(JobStoreTest, ListsNewestFirstByPages) {
  for (const char* id : {"j1", "j2", "j3"}) ASSERT_TRUE(jobs_.Insert(NewJob(id), "").ok());
  EXPECT_EQ(jobs_.List({.limit = 2})->at(0).id(), "j3");
  EXPECT_EQ(jobs_.List({.limit = 2, .before = "j2"})->at(0).id(), "j1");
  EXPECT_THAT(*jobs_.List({.limit = 2, .before = "j1"}), IsEmpty());
  EXPECT_THAT(*jobs_.List({.batch_id = "b1"}), IsEmpty());
  EXPECT_THAT(*jobs_.List({.owner = "ann"}), IsEmpty());
  EXPECT_EQ(jobs_.List({.owner = "", .state = v1::JOB_STATE_QUEUED})->size(), 3u);
}

TEST_F(JobStoreTest, NumbersEventsWithinAJob) {
  for (const char* id : {"j1", "j2"}) ASSERT_TRUE(jobs_.Insert(NewJob(id), "").ok());
  for (const char* id : {"j1", "j1", "j2"}) {
    ChangeJob(id, [](store::v1::JobRecord& record) { ReturnJob(record, absl::InfinitePast(), "again"); });
  }
  EXPECT_EQ(store_->jobs().EventsAfter("j1", 0, 10)->size(), 2u);
  EXPECT_EQ(store_->jobs().EventsAfter("j1", 1, 10)->at(0).sequence(), 2);
  EXPECT_EQ(store_->jobs().EventsAfter("j2", 0, 10)->at(0).sequence(), 1);
}

TEST_F(JobStoreTest, KeepsNothingOfATransactionThatWasNotCommitted) {
  {
    auto transaction = *Transaction::Begin(store_->database());
    ASSERT_TRUE(jobs_.Insert(NewJob("j1"), "").ok());
  }
  EXPECT_EQ(jobs_.Get("j1").status().code(), absl::StatusCode::kNotFound);
}

TEST_F(JobStoreTest, CountsABatch) {
  store::v1::BatchRecord record;
  record.mutable_batch()->set_id("b1");
  record.set_request_id("r1");
  ASSERT_TRUE(store_->batches().Insert(record).ok());
  record.mutable_batch()->set_job_count(3);
  ASSERT_TRUE(store_->batches().Save(record.batch()).ok());
  for (const char* id : {"j1", "j2", "j3"}) {
    v1::Job job = NewJob(id);
    job.set_batch_id("b1");
    ASSERT_TRUE(jobs_.Insert(job, "").ok());
  }
  ChangeJob("j1", [](store::v1::JobRecord& job) {
    JobEnd end;
    end.state = v1::JOB_STATE_FAILED;
    end.failure_kind = v1::FAILURE_KIND_WORKER;
    end.time = absl::FromUnixSeconds(1'800'000'000);
    EndJob(job, end);
  });
  Claim("j2", "me");
  const v1::Batch batch = *store_->batches().GetWithCounts("b1");
  EXPECT_EQ(batch.job_count(), 3);
  EXPECT_EQ(batch.open_count(), 2);
  EXPECT_EQ(batch.running_count(), 1);
  EXPECT_EQ(batch.failed_count(), 1);
  ASSERT_EQ(batch.failures_size(), 1);
  EXPECT_EQ(batch.failures(0).kind(), v1::FAILURE_KIND_WORKER);
  EXPECT_EQ(store_->batches().Get("b2").status().code(), absl::StatusCode::kNotFound);
}

TEST_F(JobStoreTest, LeavesJobsOfLivingOwnersAloneAndTakesThoseOfDeadOnes) {
  ASSERT_TRUE(jobs_.Insert(NewJob("j1"), "").ok());
  ASSERT_TRUE(jobs_.Insert(NewJob("j2"), "").ok());
  auto other = *JobStore::Open(folder_.path());
  Claim("j1", other->owner());
  Claim("j2", "died-without-a-lock-file");
  ASSERT_TRUE(store_->ReleaseDeadOwners().ok());
  EXPECT_EQ(jobs_.Get("j1")->state(), v1::JOB_STATE_RUNNING);
  EXPECT_EQ(jobs_.Get("j2")->state(), v1::JOB_STATE_QUEUED);
  other = nullptr;
  ASSERT_TRUE(store_->ReleaseDeadOwners().ok());
  EXPECT_EQ(jobs_.Get("j1")->state(), v1::JOB_STATE_QUEUED);
}

TEST_F(JobStoreTest, RefusesWritesOfARunThatHasBeenSuperseded) {
  ASSERT_TRUE(jobs_.Insert(NewJob("j1"), "").ok());
  const auto queue = *SqliteWorkQueue::Open(folder_.path(), runtime::SystemClock());
  const std::unique_ptr<Lease> first = *queue->Take({});
  ASSERT_NE(first, nullptr);
  ChangeJob("j1", [](store::v1::JobRecord& record) { ReturnJob(record, absl::InfinitePast(), ""); });
  StageRecord room;
  room.event.set_stage("room");
  EXPECT_EQ(first->Record(room).code(), absl::StatusCode::kAborted) << "nobody has it";
  const std::unique_ptr<Lease> second = *queue->Take({});
  ASSERT_NE(second, nullptr);
  EXPECT_EQ(first->Record(room).code(), absl::StatusCode::kAborted);
  EXPECT_EQ(first->End({}).code(), absl::StatusCode::kAborted);
  EXPECT_TRUE(first->lost());
  Claim("j1", "other");
  EXPECT_EQ(second->Record(room).code(), absl::StatusCode::kAborted) << "another process has it";
  ChangeJob("j1", [](store::v1::JobRecord& record) { ReturnJob(record, absl::InfinitePast(), ""); });
  const std::unique_ptr<Lease> third = *queue->Take({});
  ASSERT_NE(third, nullptr);
  EXPECT_TRUE(third->Record(room).ok());
}

TEST(JobStore, BringsAStoreOfTheFirstVersionUpToDate) {
  TemporaryFolder folder;
  sqlite3* connection = nullptr;
  ASSERT_EQ(sqlite3_open((folder.path() + "/jobs.db").c_str(), &connection), SQLITE_OK);
  std::ifstream file(FLAIR_SOURCE_DIR "/orchestrator/store/schema.sql");
  std::string sql(std::istreambuf_iterator<char>(file), {});
  sql += "PRAGMA user_version = 1; INSERT INTO batches VALUES ('b1', 'r1', 'd');";
  for (const char* id : {"j2", "j1"}) {
    sql += std::string("INSERT INTO jobs (id, spec, state, create_time_us, batch_id) VALUES ('") + id +
           "', x'', 3, 1, 'b1');";
  }
  ASSERT_EQ(sqlite3_exec(connection, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK);
  sqlite3_close(connection);
  const auto store = *JobStore::Open(folder.path());
  const v1::Batch batch = *store->batches().GetWithCounts("b1");
  EXPECT_EQ(batch.job_count(), 2);
  EXPECT_EQ(batch.succeeded_count(), 2);
  EXPECT_EQ(batch.state(), v1::BATCH_STATE_ACTIVE);
  EXPECT_EQ(store->jobs().Get("j2")->batch_index(), 1);
  EXPECT_EQ(store->batches().EndsAfter("b1", 0, 10)->size(), 2u);
}

TEST(Database, ManyMayOpenANewFileAtOnce) {
  constexpr int kOpeners = 8;
  for (int round = 0; round < 20; ++round) {
    TemporaryFolder folder;
    std::latch together(kOpeners);
    std::vector<absl::Status> statuses(kOpeners);
    std::vector<std::thread> openers;
    for (absl::Status& status : statuses) {
      openers.emplace_back([&] {
        together.arrive_and_wait();
        status = Database::Open(folder.path() + "/new.db").status();
      });
    }
    for (std::thread& opener : openers) opener.join();
    for (const absl::Status& status : statuses) EXPECT_TRUE(status.ok()) << status;
  }
}

TEST(JobStore, SaysWhatIsWrongWithItsFolder) {
  EXPECT_EQ(JobStore::Open("").status().code(), absl::StatusCode::kInvalidArgument);
  const absl::Status status = JobStore::Open("/proc/no/such/folder").status();
  EXPECT_EQ(status.code(), absl::StatusCode::kUnavailable);
  EXPECT_THAT(std::string(status.message()), HasSubstr("/proc/no/such/folder"));
}

TEST(JobStore, IsItsOwnersAlone) {
  TemporaryFolder folder;
  for (const std::string& made : {folder.path() + "/a/store", folder.path() + "/a/artifacts"}) {
    ASSERT_TRUE(made.ends_with("store") ? JobStore::Open(made).ok() : ArtifactFiles::Open(made).ok());
    EXPECT_EQ(std::filesystem::status(made).permissions(), std::filesystem::perms::owner_all) << made;
  }
}

TEST(JobStore, RefusesAFileThatIsNoDatabase) {
  TemporaryFolder folder;
  std::ofstream(folder.path() + "/jobs.db") << std::string(5000, 'x');
  EXPECT_EQ(JobStore::Open(folder.path()).status().code(), absl::StatusCode::kDataLoss);
}

TEST(JobStore, WithoutItsTablesIsDamaged) {
  TemporaryFolder folder;
  ASSERT_TRUE(JobStore::Open(folder.path()).ok());
  sqlite3* connection = nullptr;
  ASSERT_EQ(sqlite3_open((folder.path() + "/jobs.db").c_str(), &connection), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(connection, "DROP TABLE jobs", nullptr, nullptr, nullptr), SQLITE_OK);
  sqlite3_close(connection);
  const absl::Status status = JobStore::Open(folder.path()).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kDataLoss);
  EXPECT_THAT(std::string(status.message()),
              HasSubstr(folder.path() + "/jobs.db: store: no such table: jobs; restore"));
}

TEST_F(JobStoreTest, WhatIsDamagedOfAJobHoldsUpNoOther) {
  ASSERT_TRUE(jobs_.Insert(NewJob("j1"), "").ok());
  ChangeJob("j1", [](store::v1::JobRecord& record) { ReturnJob(record, absl::InfinitePast(), "again"); });
  ASSERT_TRUE(store_->database().Execute("UPDATE jobs SET spec = x'ff'; UPDATE events SET event = x'ff'").ok());
  const auto job = store_->jobs().Load("j1");
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_FALSE(job->job().has_spec()) << "which JobRunner fails";
  const auto events = store_->jobs().EventsAfter("j1", 0, 10);
  ASSERT_EQ(events->size(), 1u);
  EXPECT_EQ(events->at(0).message(), "damaged in the store");
  EXPECT_EQ(events->at(0).sequence(), 1);
}

TEST(JobStore, RefusesAStoreOfANewerVersion) {
  TemporaryFolder folder;
  ASSERT_TRUE(JobStore::Open(folder.path()).ok());
  sqlite3* connection = nullptr;
  ASSERT_EQ(sqlite3_open((folder.path() + "/jobs.db").c_str(), &connection), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(connection, "PRAGMA user_version = 999", nullptr, nullptr, nullptr), SQLITE_OK);
  sqlite3_close(connection);
  EXPECT_EQ(JobStore::Open(folder.path()).status().code(), absl::StatusCode::kFailedPrecondition);
}

}  // namespace
}  // namespace flair::orchestrator
