// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/contract/queue/queue_test.h"

namespace flair::testing {

orchestrator::SealedArtifact DeletionContract::Seal(const std::string& text) {
  v1::Artifact artifact;
  artifact.mutable_brief()->set_text(text);
  return orchestrator::SealArtifact(artifact);
}

orchestrator::StageRecord DeletionContract::Record(const orchestrator::Lease& lease, const v1::ArtifactRef& artifact,
                                                   const std::string& result_key) {
  orchestrator::StageRecord record;
  record.event.set_job_id(lease.job().id());
  record.event.set_kind(v1::JOB_EVENT_KIND_STAGE_FINISHED);
  record.event.set_stage("brief");
  record.event.set_state(v1::JOB_STATE_RUNNING);
  *record.event.mutable_artifact() = artifact;
  record.result_key = result_key;
  return record;
}

absl::Status DeletionContract::Store(orchestrator::Lease& lease, const std::string& text, int stage_index) {
  const orchestrator::SealedArtifact sealed = Seal(text);
  orchestrator::StageRecord record = Record(lease, sealed.ref, "key-of-" + text);
  record.stage_index = stage_index;
  absl::Status status = lease.Announce(std::span(&record, 1));
  if (status.ok()) status = artifacts_->PutAll(std::span(&sealed, 1));
  return status.ok() ? lease.Record(record) : status;
}

std::vector<std::string> DeletionContract::RunAlone(WatchedQueue& queue, const std::string& id,
                                                    const std::vector<std::string>& texts) {
  EXPECT_TRUE(queue->CreateJob(NewJob(id), "request of " + id).ok());
  const auto lease = queue.Take();
  if (lease == nullptr) {
    ADD_FAILURE() << "no job to take";
    return std::vector<std::string>(texts.size());
  }
  std::vector<std::string> ids;
  for (const std::string& text : texts) {
    EXPECT_TRUE(Store(*lease, text, static_cast<int>(ids.size())).ok());
    ids.push_back(IdOf(text));
  }
  EXPECT_TRUE(EndAs(*lease, v1::JOB_STATE_SUCCEEDED).ok());
  return ids;
}

void DeletionContract::RunBatch(WatchedQueue& queue, const std::string& id, int64_t job_count,
                                const std::vector<std::string>& texts, v1::JobState state) {
  ASSERT_TRUE(queue->CreateBatch(NewBatch(id)).ok());
  ASSERT_TRUE(queue->AddJobs(id, JobsOf(id, 0, job_count), true).ok());
  for (int64_t i = 0; i < job_count; ++i) {
    const auto lease = queue.Take();
    ASSERT_NE(lease, nullptr);
    int stage = 0;
    for (const std::string& text : texts) {
      ASSERT_TRUE(Store(*lease, text == "own" ? "own-of-" + lease->job().id() : text, stage++).ok());
    }
    ASSERT_TRUE(EndAs(*lease, state).ok());
  }
}

void DeletionContract::ExpectWhole(WatchedQueue& queue, const std::string& id, int64_t job_count) {
  const auto batch = queue->GetBatch(id);
  ASSERT_TRUE(batch.ok()) << batch.status();
  EXPECT_EQ(batch->job_count(), job_count);
  EXPECT_FALSE(batch->open());
  EXPECT_EQ(batch->open_count(), 0);
  const auto jobs = queue->ListJobs({.limit = 1000, .batch_id = id});
  ASSERT_TRUE(jobs.ok()) << jobs.status();
  EXPECT_EQ(static_cast<int64_t>(jobs->size()), job_count);
  for (const v1::Job& job : *jobs) {
    for (const v1::ArtifactRef& artifact : job.artifacts()) {
      EXPECT_TRUE(artifacts_->Get(artifact.id()).ok()) << job.id();
    }
  }
}

}  // namespace flair::testing
