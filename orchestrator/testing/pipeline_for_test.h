// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "orchestrator/pipeline/pipeline.h"
#include "orchestrator/store/local_artifacts.h"
#include "orchestrator/store/sqlite_work_queue.h"
#include "orchestrator/testing/temporary_folder.h"
#include "worker_runtime/testing/fakes.h"

namespace flair::orchestrator {

// A pipeline on a store of its own, one job at a time, and what it left there.
class PipelineForTest {
 public:
  PipelineForTest() { MoveTo(folder_.path()); }

  // Another folder from now on.
  void MoveTo(const std::string& folder) {
    artifacts_ = std::make_unique<ArtifactFiles>(folder + "/artifacts");
    queue_ = *SqliteWorkQueue::Open(folder, clock_);
  }

  // Runs the job, which it makes unless there is one of that id already. The job waits again afterwards.
  PipelineResult Run(StageClients& clients, const v1::Job& job) {
    EXPECT_TRUE(queue_->CreateJob(job, job.id()).ok());
    TakeFilter filter;
    filter.any = false;
    filter.job_ids = {job.id()};
    const std::unique_ptr<Lease> lease = *queue_->Take(filter);
    lease_ = lease.get();
    return Pipeline(*queue_, *artifacts_, clients, clock_, options_).Run(*lease);
  }

  // Of the job that runs.
  runtime::Cancellation& cancellation() { return lease_->cancellation(); }

  v1::Job Get(const std::string& job_id) { return *queue_->GetJob(job_id); }
  std::vector<v1::JobEvent> Events(const std::string& job_id) { return *queue_->EventsAfter(job_id, 0, 1000); }
  v1::Artifact Artifact(const std::string& id) { return *artifacts_->Get(id); }
  std::string PathOf(const std::string& id) { return artifacts_->PathOf(id); }

  runtime::FakeClock& clock() { return clock_; }
  PipelineOptions& options() { return options_; }
  WorkQueue& queue() { return *queue_; }

 private:
  TemporaryFolder folder_;
  runtime::FakeClock clock_;
  PipelineOptions options_;
  std::unique_ptr<ArtifactFiles> artifacts_;
  std::unique_ptr<WorkQueue> queue_;
  Lease* lease_ = nullptr;
};

}  // namespace flair::orchestrator
