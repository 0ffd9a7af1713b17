// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the jobs of one batch on a store with fake workers, replays a third of them, and runs a job with a layout that
// is there, for crash_test.cc: crash_test_child STORE JOB_COUNT. Writes a line before every call of a stage, and "done"
// when all jobs have ended.
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "orchestrator/testing/embedded_for_test.h"
#include "orchestrator/testing/fake_stages.h"
#include "orchestrator/testing/fake_workers.h"

namespace flair::orchestrator {
namespace {

using Stub = v1::OrchestratorService::StubInterface;

// Waits for all jobs of a batch and returns them, oldest first; none when something failed.
std::vector<v1::Job> RunBatch(EmbeddedForTest& orchestrator, const v1::CreateBatchRequest& request) {
  const auto batch = orchestrator.Ask(&Stub::CreateBatch, request);
  if (!batch.ok()) return {};
  v1::ListJobsRequest list;
  list.set_page_size(1000);
  list.set_batch_id(batch->batch().id());
  const auto jobs = orchestrator.Ask(&Stub::ListJobs, list);
  if (!jobs.ok()) return {};
  for (const v1::Job& job : jobs->jobs()) orchestrator.Watch(job.id());
  return {jobs->jobs().rbegin(), jobs->jobs().rend()};
}

// Waits for a job with the layout of another one.
bool RunGiven(EmbeddedForTest& orchestrator, const v1::Job& other) {
  v1::CreateJobRequest request;
  request.set_request_id("given");
  request.mutable_spec()->mutable_brief()->set_text("Given");
  v1::GetArtifactRequest layout;
  const absl::StatusOr<v1::Job> ended = orchestrator.GetJob(other.id());
  if (!ended.ok()) return false;
  for (const v1::ArtifactRef& ref : ended->artifacts()) {
    if (ref.kind() == v1::ARTIFACT_KIND_SOLVED_LAYOUT) layout.set_artifact_id(ref.id());
  }
  const auto artifact = orchestrator.Ask(&Stub::GetArtifact, layout);
  if (!artifact.ok()) return false;
  *request.mutable_layout() = artifact->artifact();
  const auto job = orchestrator.Ask(&Stub::CreateJob, request);
  if (job.ok()) orchestrator.Watch(job->job().id());
  return job.ok();
}

}  // namespace
}  // namespace flair::orchestrator

int main(int argc, char** argv) {
  using namespace flair;
  using namespace flair::orchestrator;
  if (argc != 3) return 2;
  FakeStages stages([](std::string_view rpc, runtime::CallContext&) {
    std::printf("%.*s\n", static_cast<int>(rpc.size()), rpc.data());
    std::fflush(stdout);
    return absl::OkStatus();
  });
  FakeWorkers workers(stages);
  config::v1::OrchestratorConfig config;
  config.set_store_path(argv[1]);
  config.set_running_job_limit(2);
  config.mutable_runtime()->set_log_level("error");
  EmbeddedForTest orchestrator(config, workers.channels());
  if (!orchestrator.status().ok()) return 1;
  v1::CreateBatchRequest request;
  request.set_request_id("batch");
  for (int i = 0; i < std::atoi(argv[2]); ++i)
    request.add_specs()->mutable_brief()->set_text("Room " + std::to_string(i));
  const std::vector<v1::Job> jobs = RunBatch(orchestrator, request);
  v1::CreateBatchRequest replays;
  replays.set_request_id("replays");
  for (size_t i = 0; i < jobs.size(); i += 3) {
    *replays.add_specs() = jobs[i].spec();
    replays.mutable_specs()->rbegin()->mutable_replay()->set_job_id(jobs[i].id());
    replays.mutable_specs()->rbegin()->mutable_replay()->set_from_stage("objects");
  }
  if (RunBatch(orchestrator, replays).empty() || !RunGiven(orchestrator, jobs.front())) return 1;
  std::printf("done\n");
  return 0;
}
