// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <prometheus/text_serializer.h>
#include <spdlog/sinks/ostream_sink.h>

#include <sstream>

#include "orchestrator/batch/queue_metrics.h"
#include "orchestrator/store/sqlite_work_queue.h"
#include "orchestrator/testing/temporary_folder.h"
#include "worker_runtime/metrics/prometheus_metrics.h"
#include "worker_runtime/testing/fakes.h"

namespace flair::orchestrator {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

class MeteredQueue : public ::testing::Test {
 protected:
  MeteredQueue() {
    auto inner = SqliteWorkQueue::Open(folder_.path(), clock_);
    EXPECT_TRUE(inner.ok()) << inner.status();
    queue_ = MakeMeteredWorkQueue(
        *std::move(inner), metrics_, clock_,
        std::make_shared<spdlog::logger>("test", std::make_shared<spdlog::sinks::ostream_sink_mt>(log_)));
  }
  void Create(const std::string& id, const std::string& request = "a request") {
    v1::Job job;
    job.set_id(id);
    job.set_state(v1::JOB_STATE_QUEUED);
    job.mutable_create_time()->set_seconds(absl::ToUnixSeconds(clock_.Now()));
    ASSERT_TRUE(queue_->CreateJob(job, request).ok());
  }
  std::unique_ptr<Lease> Take() {
    auto lease = queue_->Take({});
    EXPECT_TRUE(lease.ok() && *lease != nullptr) << lease.status();
    return *std::move(lease);
  }
  std::string Figures() const { return prometheus::TextSerializer().Serialize(metrics_.Collect()); }

  TemporaryFolder folder_;
  runtime::FakeClock clock_;
  runtime::PrometheusMetrics metrics_;
  std::ostringstream log_;
  std::unique_ptr<WorkQueue> queue_;
};

TEST_F(MeteredQueue, CountsAJobFromItsMakingToItsEnd) {
  Create("a");
  // The same request again: it gets the first job.
  Create("b");
  clock_.Advance(absl::Seconds(20));
  {
    const auto lease = Take();
    EXPECT_THAT(Figures(), HasSubstr("\nflair_jobs_running 1\n"));
    v1::JobEvent event;
    event.set_job_id("a");
    event.set_kind(v1::JOB_EVENT_KIND_STAGE_FINISHED);
    event.set_stage("solve");
    event.mutable_duration()->set_nanos(40000000);
    ASSERT_TRUE(lease->Record({event, 0, ""}).ok());
    event.set_kind(v1::JOB_EVENT_KIND_STAGE_REUSED);
    ASSERT_TRUE(lease->Record({event, 0, ""}).ok());
    clock_.Advance(absl::Seconds(4));
    ASSERT_TRUE(lease
                    ->End({v1::JOB_STATE_FAILED, "render", absl::UnavailableError("no renderer"),
                           v1::FAILURE_KIND_WORKER, clock_.Now()})
                    .ok());
  }
  const std::string figures = Figures();
  for (const std::string line :
       {"flair_jobs_created_total{form=\"single\"} 1", "flair_jobs_running 0", "flair_job_wait_seconds_sum 20",
        "flair_job_run_duration_seconds_sum 4", "flair_job_duration_seconds_sum 24",
        "flair_job_runs_total{outcome=\"ended\"} 1", "flair_jobs_ended_total{failure=\"worker\",state=\"failed\"} 1",
        "flair_stages_total{outcome=\"made\",stage=\"solve\"} 1",
        "flair_stages_total{outcome=\"reused\",stage=\"solve\"} 1",
        "flair_stages_total{outcome=\"failed\",stage=\"render\"} 1",
        "flair_stage_duration_seconds_sum{stage=\"solve\"} 0.04"}) {
    EXPECT_THAT(figures, HasSubstr("\n" + line + "\n"));
  }
}

TEST_F(MeteredQueue, TellsRunsApartThatEndNoJob) {
  Create("a");
  ASSERT_TRUE(Take()->Return(absl::ZeroDuration(), "no optimizer").ok());
  Take().reset();
  EXPECT_THAT(Figures(), AllOf(HasSubstr("flair_job_runs_total{outcome=\"retried\"} 1"),
                               HasSubstr("flair_job_runs_total{outcome=\"interrupted\"} 1"),
                               HasSubstr("flair_jobs_ended_total{failure=\"none\",state=\"succeeded\"} 0"),
                               Not(ContainsRegex("flair_jobs_ended_total[^ ]* [1-9]"))));
  // Waiting is measured once.
  EXPECT_THAT(Figures(), HasSubstr("\nflair_job_wait_seconds_count 1\n"));
}

TEST_F(MeteredQueue, ShowsWhatTheProcessLastSaidOfItself) {
  Create("a");
  v1::OrchestratorStatus status;
  status.set_id("me");
  status.set_running_limit(4);
  for (const v1::WorkerState state : {v1::WORKER_STATE_READY, v1::WORKER_STATE_BROKEN, v1::WORKER_STATE_READY}) {
    v1::WorkerStatus& worker = *status.add_workers();
    worker.set_stage("optimizer");
    worker.set_state(state);
  }
  ASSERT_TRUE(queue_->ReportStatus(status).ok());
  const std::string figures = Figures();
  for (const std::string line :
       {"flair_jobs_queued 1", "flair_jobs_running_limit 4", "flair_workers{stage=\"optimizer\",state=\"ready\"} 2",
        "flair_workers{stage=\"optimizer\",state=\"broken\"} 1",
        "flair_workers{stage=\"language\",state=\"ready\"} 0"}) {
    EXPECT_THAT(figures, HasSubstr("\n" + line + "\n"));
  }
}

TEST_F(MeteredQueue, LogsEveryStepOnce) {
  Create("a");
  ASSERT_TRUE(Take()->End({v1::JOB_STATE_SUCCEEDED, "", {}, v1::FAILURE_KIND_UNSPECIFIED, clock_.Now()}).ok());
  const std::string log = log_.str();
  for (const std::string step : {"job made", "job taken", "job ended"}) {
    const size_t first = log.find(step);
    EXPECT_NE(first, std::string::npos) << step;
    EXPECT_EQ(log.find(step, first + 1), std::string::npos) << step;
  }
}

}  // namespace
}  // namespace flair::orchestrator
