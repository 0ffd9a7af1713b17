// SPDX-License-Identifier: GPL-3.0-or-later
// Whose a layout is that somebody brought along.
#include <gmock/gmock.h>

#include "orchestrator/pipeline/pipeline.h"
#include "orchestrator/service/orchestrator_handlers.h"
#include "orchestrator/store/local_artifacts.h"
#include "orchestrator/store/sqlite_work_queue.h"
#include "orchestrator/testing/fake_stages.h"
#include "orchestrator/testing/temporary_folder.h"
#include "spdlog/sinks/null_sink.h"
#include "tests/fixtures/bedroom.h"
#include "worker_runtime/testing/fakes.h"

namespace flair::orchestrator {
namespace {

class OwnedLayout : public ::testing::Test {
 protected:
  static v1::CreateJobRequest Request(const std::string& id, double x_m) {
    v1::CreateJobRequest request;
    request.set_request_id(id);
    request.mutable_spec()->mutable_brief()->set_text("A bedroom.");
    v1::SolvedLayout& layout = *request.mutable_layout()->mutable_solved_layout();
    *layout.mutable_graph() = flair::testing::BedroomGraph();
    for (const v1::Object& object : layout.graph().object_list().objects()) {
      v1::Placement& at = *layout.add_placements();
      at.set_object_id(object.id());
      at.set_x_m(x_m);
    }
    return request;
  }

  absl::Status Get(const Caller& caller, const std::string& artifact_id) {
    v1::GetArtifactRequest request;
    request.set_artifact_id(artifact_id);
    return handlers_.GetArtifact(request, caller).status();
  }

  const Caller ada_ = {.name = "ada", .sees_all = false, .open_job_limit = 1};
  const Caller bob_ = {.name = "bob", .sees_all = false, .open_job_limit = 1};
  TemporaryFolder folder_;
  runtime::FakeClock clock_;
  const std::unique_ptr<WorkQueue> queue_ = *SqliteWorkQueue::Open(folder_.path(), clock_);
  const std::unique_ptr<LocalArtifacts> artifacts_ = *LocalArtifacts::Open(folder_.path() + "/artifacts");
  FakeStages stages_;
  const Pipeline pipeline_{*queue_, *artifacts_, stages_, clock_, {}};
  spdlog::logger logger_{"runner", std::make_shared<spdlog::sinks::null_sink_mt>()};
  // It runs none.
  JobRunner runner_{*queue_, pipeline_, clock_, logger_, {.running_job_limit = 0}};
  OrchestratorHandlers handlers_{*queue_, *artifacts_, runner_, clock_, 100, [] { return v1::OrchestratorStatus(); }};
};

TEST_F(OwnedLayout, IsItsOwnersAloneAndWithinTheQuota) {
  const auto made = handlers_.CreateJob(Request("r1", 1), ada_);
  ASSERT_TRUE(made.ok()) << made.status();
  const std::string id = made->job().artifacts(0).id();
  EXPECT_TRUE(Get(ada_, id).ok());
  EXPECT_TRUE(absl::IsNotFound(Get(bob_, id)));
  // One more is one too many, a repeat is none.
  EXPECT_TRUE(absl::IsResourceExhausted(handlers_.CreateJob(Request("r2", 2), ada_).status()));
  EXPECT_EQ(handlers_.CreateJob(Request("r1", 1), ada_)->job().id(), made->job().id());
  v1::ListJobsResponse listed = *handlers_.ListJobs({}, ada_);
  ASSERT_EQ(listed.jobs_size(), 1);
  EXPECT_LT(listed.jobs(0).ByteSizeLong(), 500);
  EXPECT_EQ(handlers_.ListJobs({}, bob_)->jobs_size(), 0);
  // Who has the same layout has it too, by a job of their own.
  const auto of_bob = handlers_.CreateJob(Request("r1", 1), bob_);
  ASSERT_TRUE(of_bob.ok()) << of_bob.status();
  EXPECT_NE(of_bob->job().id(), made->job().id());
  EXPECT_TRUE(Get(bob_, id).ok());
  // What is refused is not stored.
  v1::Artifact other = Request("r2", 2).layout();
  EXPECT_TRUE(absl::IsNotFound(artifacts_->Get(SealArtifact(other).ref.id()).status()));
}

}  // namespace
}  // namespace flair::orchestrator
