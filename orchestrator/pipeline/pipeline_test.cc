// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/pipeline/pipeline.h"

#include <gmock/gmock.h>
#include <google/protobuf/util/time_util.h>

#include <filesystem>
#include <fstream>

#include "orchestrator/pipeline/stage.h"
#include "orchestrator/testing/fake_stages.h"
#include "orchestrator/testing/pipeline_for_test.h"
#include "worker_runtime/testing/fakes.h"

namespace flair::orchestrator {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class PipelineTest : public ::testing::Test {
 protected:
  void SetUp() override {
    // Tests do not wait; they count how often they would have and let the clock pass.
    options_.wait = [this](absl::Duration duration, runtime::CallContext&) {
      ++waits_;
      pipeline_.clock().Advance(duration);
    };
  }

  v1::Job NewJob(const std::string& id, const std::string& text = "A bedroom.", int64_t seed = 1) {
    v1::Job job;
    job.set_id(id);
    job.mutable_spec()->mutable_brief()->set_text(text);
    job.mutable_spec()->mutable_brief()->set_seed(seed);
    return job;
  }

  PipelineResult Run(StageClients& clients, const v1::Job& job) { return pipeline_.Run(clients, job); }

  std::vector<std::string> Ids(const std::string& job_id, bool with_report = false) {
    std::vector<std::string> ids;
    const v1::Job job = pipeline_.Get(job_id);
    for (const v1::ArtifactRef& ref : job.artifacts()) {
      if (with_report || ref.kind() != v1::ARTIFACT_KIND_REPORT) ids.push_back(ref.id());
    }
    return ids;
  }

  int CountEvents(const std::string& job_id, v1::JobEventKind kind) {
    int count = 0;
    for (const v1::JobEvent& event : pipeline_.Events(job_id)) count += event.kind() == kind ? 1 : 0;
    return count;
  }

  PipelineForTest pipeline_;
  PipelineOptions& options_ = pipeline_.options();
  int waits_ = 0;
};

TEST_F(PipelineTest, StoresOneArtifactPerStageInOrder) {
  FakeStages stages;
  const PipelineResult result = Run(stages, NewJob("j1"));
  ASSERT_TRUE(result.status.ok()) << result.status;
  std::vector<int> kinds;
  const v1::Job job = pipeline_.Get("j1");
  for (const v1::ArtifactRef& ref : job.artifacts()) kinds.push_back(ref.kind());
  EXPECT_THAT(kinds, ElementsAre(1, 2, 3, 4, 5, 6, 7, 12, 8, 9, 10, 11));
  EXPECT_EQ(stages.all_calls(), 12);
}

TEST_F(PipelineTest, ReportsWhatModelsConsumedForThisJobOnly) {
  FakeStages stages;
  v1::Job job = NewJob("j1");
  job.mutable_spec()->mutable_model_options()->set_stand_in_allowed(true);
  ASSERT_TRUE(Run(stages, job).status.ok());
  const v1::Report report = pipeline_.Artifact(Ids("j1", true).back()).report();
  EXPECT_EQ(report.model_usage().call_count(), 7);
  EXPECT_EQ(report.model_usage().input_token_count(), 560);
  EXPECT_EQ(report.model_usage().cost_usd(), 1.75);
  v1::Job again = NewJob("j2");
  *again.mutable_spec() = job.spec();
  ASSERT_TRUE(Run(stages, again).status.ok());
  EXPECT_FALSE(pipeline_.Artifact(Ids("j2", true).back()).report().has_model_usage());
}

TEST_F(PipelineTest, ABudgetIsThatOfTheWholeJob) {
  for (int calls = 0; calls <= 7; ++calls) {
    FakeStages stages;
    v1::Job job = NewJob("j" + std::to_string(calls), "Bedroom " + std::to_string(calls));
    job.mutable_spec()->mutable_model_options()->mutable_budget()->set_call_count(calls);
    const PipelineResult result = Run(stages, job);
    if (calls == 7) {
      EXPECT_TRUE(result.status.ok()) << result.status;
      continue;
    }
    EXPECT_TRUE(absl::IsFailedPrecondition(result.status)) << calls << ": " << result.status;
    // Completion, after the sixth, asks no model.
    EXPECT_EQ(pipeline_.Get(job.id()).artifacts_size(), 1 + calls + (calls == 6 ? 1 : 0));
  }
}

TEST_F(PipelineTest, TheBudgetDecidesNoResultButWhatModelsMayDoDoes) {
  FakeStages stages;
  v1::Job job = NewJob("j1");
  job.mutable_spec()->mutable_model_options()->mutable_budget()->set_token_count(1000);
  ASSERT_TRUE(Run(stages, job).status.ok());
  const int calls = stages.calls("DescribeRoom");
  v1::Job richer = NewJob("j2");
  richer.mutable_spec()->mutable_model_options()->mutable_budget()->set_token_count(2000);
  ASSERT_TRUE(Run(stages, richer).status.ok());
  EXPECT_EQ(stages.calls("DescribeRoom"), calls);
  v1::Job other = NewJob("j3");
  other.mutable_spec()->mutable_model_options()->set_texts_omitted(true);
  ASSERT_TRUE(Run(stages, other).status.ok());
  EXPECT_EQ(stages.calls("DescribeRoom"), calls + 1);
}

TEST_F(PipelineTest, SaysWhatEachArtifactWasMadeFrom) {
  FakeStages stages;
  ASSERT_TRUE(Run(stages, NewJob("j1")).status.ok());
  const std::vector<std::string> ids = Ids("j1", true);
  for (size_t i = 0; i < ids.size(); ++i) {
    const v1::Artifact artifact = pipeline_.Artifact(ids[i]);
    EXPECT_EQ(artifact.made_from_ids_size(), static_cast<int>(Stages()[i].inputs.size())) << Stages()[i].name;
    for (const std::string& from : artifact.made_from_ids()) EXPECT_THAT(ids, ::testing::Contains(from));
    EXPECT_FALSE(artifact.producer().program().empty());
  }
}

TEST_F(PipelineTest, MakesTheSameArtifactsInAnotherStore) {
  FakeStages stages;
  ASSERT_TRUE(Run(stages, NewJob("j1")).status.ok());
  const std::vector<std::string> first = Ids("j1");
  TemporaryFolder other;
  pipeline_.MoveTo(other.path());
  ASSERT_TRUE(Run(stages, NewJob("j2")).status.ok());
  EXPECT_EQ(Ids("j2"), first);
}

TEST_F(PipelineTest, RunsOnlyTheReportForAJobThatWasMadeBefore) {
  FakeStages stages;
  ASSERT_TRUE(Run(stages, NewJob("j1")).status.ok());
  FakeStages again;
  ASSERT_TRUE(Run(again, NewJob("j2")).status.ok());
  EXPECT_EQ(Ids("j2"), Ids("j1"));
  EXPECT_EQ(again.calls("Evaluate"), 1);
  EXPECT_EQ(again.calls("ListConstraintTypes"), 1);
  EXPECT_EQ(again.all_calls(), 2);
  EXPECT_EQ(CountEvents("j2", v1::JOB_EVENT_KIND_STAGE_REUSED), 11);
}

TEST_F(PipelineTest, SolvesAgainForOtherOptionsButNotForMoreThreads) {
  FakeStages stages;
  ASSERT_TRUE(Run(stages, NewJob("j1")).status.ok());
  v1::Job threads = NewJob("j2");
  threads.mutable_spec()->mutable_solve_options()->set_thread_count(4);
  ASSERT_TRUE(Run(stages, threads).status.ok());
  EXPECT_EQ(stages.calls("Solve"), 1);
  v1::Job restarts = NewJob("j3");
  restarts.mutable_spec()->mutable_solve_options()->set_max_restart_count(3);
  ASSERT_TRUE(Run(stages, restarts).status.ok());
  EXPECT_EQ(stages.calls("Solve"), 2);
  EXPECT_EQ(stages.calls("Translate"), 1);
}

TEST_F(PipelineTest, DoesNotUseResultsOfAnotherRevision) {
  FakeStages stages;
  ASSERT_TRUE(Run(stages, NewJob("j1")).status.ok());
  stages.set_revision("2");
  ASSERT_TRUE(Run(stages, NewJob("j2")).status.ok());
  EXPECT_EQ(stages.calls("Solve"), 2);
}

TEST_F(PipelineTest, UsesResultsOfWorkersThatDoNotSayWhichTheyAreForTheirJobOnly) {
  FakeStages broken([](std::string_view rpc, runtime::CallContext&) {
    return rpc == "Render" ? absl::InternalError("power cut") : absl::OkStatus();
  });
  broken.set_revision(std::nullopt);
  const v1::Job job = NewJob("j1");
  ASSERT_FALSE(Run(broken, job).status.ok());
  FakeStages stages;
  stages.set_revision(std::nullopt);
  ASSERT_TRUE(Run(stages, job).status.ok());
  EXPECT_EQ(stages.calls("Solve"), 0);
  ASSERT_TRUE(Run(stages, NewJob("j2")).status.ok());
  EXPECT_EQ(stages.calls("Solve"), 1);
  EXPECT_EQ(stages.calls("Render"), 2);
}

TEST_F(PipelineTest, ReportsWhatTheSolverSaidWhenItCannotEvaluate) {
  FakeStages stages([](std::string_view rpc, runtime::CallContext&) {
    return rpc == "Evaluate" ? absl::UnimplementedError("") : absl::OkStatus();
  });
  const PipelineResult result = Run(stages, NewJob("j1"));
  ASSERT_TRUE(result.status.ok()) << result.status;
  const v1::Report report = pipeline_.Artifact(Ids("j1", true).back()).report();
  EXPECT_EQ(report.constraints().satisfied_count(), 1);
  EXPECT_FALSE(report.has_metrics());
}

TEST_F(PipelineTest, GoesOnAfterTheLastStoredArtifactWithoutTellingTwice) {
  FakeStages broken([](std::string_view rpc, runtime::CallContext&) {
    return rpc == "Solve" ? absl::InternalError("power cut") : absl::OkStatus();
  });
  const v1::Job job = NewJob("j1");
  EXPECT_FALSE(Run(broken, job).status.ok());
  FakeStages stages;
  ASSERT_TRUE(Run(stages, job).status.ok());
  EXPECT_EQ(stages.calls("DescribeRoom"), 0);
  EXPECT_EQ(stages.calls("Translate"), 0);
  EXPECT_EQ(stages.calls("Solve"), 1);
  EXPECT_EQ(CountEvents("j1", v1::JOB_EVENT_KIND_STAGE_FINISHED), 12);
  EXPECT_EQ(CountEvents("j1", v1::JOB_EVENT_KIND_STAGE_REUSED), 0);
  const v1::Artifact report = pipeline_.Artifact(Ids("j1", true).back());
  ASSERT_THAT(report.report().stage_timings(), SizeIs(11));
  EXPECT_FALSE(report.report().stage_timings(1).reused());
}

TEST_F(PipelineTest, MakesDamagedAndMissingArtifactsAgain) {
  FakeStages stages;
  const v1::Job job = NewJob("j1");
  ASSERT_TRUE(Run(stages, job).status.ok());
  const std::vector<std::string> ids = Ids("j1");
  std::ofstream(pipeline_.PathOf(ids[9]), std::ios::trunc) << "damaged";
  std::filesystem::remove(pipeline_.PathOf(ids[1]));
  ASSERT_TRUE(Run(stages, NewJob("j2")).status.ok());
  EXPECT_EQ(Ids("j2"), ids);
  EXPECT_EQ(stages.calls("Solve"), 2);
  EXPECT_EQ(stages.calls("DescribeRoom"), 2);
  EXPECT_EQ(stages.calls("Translate"), 1);
  EXPECT_EQ(pipeline_.Artifact(ids[9]).id(), ids[9]);
}

TEST_F(PipelineTest, TriesAgainWhenAWorkerIsLost) {
  int failures = 3;
  FakeStages stages([&](std::string_view rpc, runtime::CallContext&) {
    return rpc == "Solve" && failures-- > 0 ? absl::UnavailableError("socket closed") : absl::OkStatus();
  });
  EXPECT_TRUE(Run(stages, NewJob("j1")).status.ok());
  EXPECT_EQ(stages.calls("Solve"), 4);
  EXPECT_EQ(waits_, 3);
}

TEST_F(PipelineTest, GivesUpOnAWorkerThatStaysAway) {
  FakeStages stages([&](std::string_view rpc, runtime::CallContext&) {
    return rpc == "DescribeRoom" ? absl::UnavailableError("language worker is not reachable") : absl::OkStatus();
  });
  const PipelineResult result = Run(stages, NewJob("j1"));
  EXPECT_EQ(result.status.code(), absl::StatusCode::kUnavailable);
  EXPECT_EQ(result.stage, "room");
  EXPECT_EQ(stages.calls("DescribeRoom"), options_.backoff.unavailable_attempt_limit);
}

TEST_F(PipelineTest, WaitsForAFullQueueAsLongAsItTakes) {
  int failures = 50;
  FakeStages stages([&](std::string_view rpc, runtime::CallContext&) {
    return rpc == "Solve" && failures-- > 0 ? absl::ResourceExhaustedError("the queue is full") : absl::OkStatus();
  });
  EXPECT_TRUE(Run(stages, NewJob("j1")).status.ok());
  EXPECT_EQ(stages.calls("Solve"), 51);
}

TEST_F(PipelineTest, GivesUpOnAQueueThatStaysFull) {
  options_.stage_deadline = absl::Seconds(60);
  FakeStages stages([&](std::string_view rpc, runtime::CallContext&) {
    return rpc == "Solve" ? absl::ResourceExhaustedError("the queue is full") : absl::OkStatus();
  });
  EXPECT_EQ(Run(stages, NewJob("j1")).status.code(), absl::StatusCode::kResourceExhausted);
  EXPECT_GT(stages.calls("Solve"), 30);
  EXPECT_LT(stages.calls("Solve"), 80);
}

TEST_F(PipelineTest, DoesNotRepeatWhatCannotSucceed) {
  for (const absl::Status& failure : {absl::InvalidArgumentError("brief.text: 0 m wide"), absl::InternalError("bug"),
                                      absl::ResourceExhaustedError("Received message larger than max (9 vs. 4)")}) {
    FakeStages stages([&](std::string_view rpc, runtime::CallContext&) {
      return rpc == "DescribeRoom" ? failure : absl::OkStatus();
    });
    EXPECT_EQ(Run(stages, NewJob("j" + failure.ToString())).status, failure);
    EXPECT_EQ(stages.calls("DescribeRoom"), 1);
  }
}

TEST_F(PipelineTest, GivesEveryCallItsDeadline) {
  options_.stage_deadline = absl::Seconds(7);
  FakeStages stages([&](std::string_view rpc, runtime::CallContext& call) {
    EXPECT_EQ(call.deadline(), pipeline_.clock().Now() + absl::Seconds(7));
    return rpc == "Solve" ? absl::DeadlineExceededError("Deadline Exceeded") : absl::OkStatus();
  });
  const PipelineResult result = Run(stages, NewJob("j1"));
  EXPECT_EQ(result.status.code(), absl::StatusCode::kDeadlineExceeded);
  EXPECT_EQ(result.stage, "solve");
  EXPECT_THAT(std::string(result.status.message()), HasSubstr("within 7s"));
}

TEST_F(PipelineTest, CancelReachesTheRunningCall) {
  FakeStages stages([&](std::string_view rpc, runtime::CallContext& call) {
    if (rpc == "Solve") pipeline_.cancellation().Cancel();
    return call.CheckAlive();
  });
  EXPECT_EQ(Run(stages, NewJob("j1")).status.code(), absl::StatusCode::kCancelled);
  EXPECT_EQ(stages.calls("Solve"), 1);
  EXPECT_EQ(stages.calls("Render"), 0);
}

TEST_F(PipelineTest, ChoosesTheStyleWhileConstraintsAreListed) {
  // Each waits for the other: they end only when they run at once.
  runtime::TestGate style;
  runtime::TestGate constraints;
  FakeStages stages([&](std::string_view rpc, runtime::CallContext&) {
    if (rpc == "ChooseStyle") style.Open(), constraints.Wait();
    if (rpc == "ListConstraints") constraints.Open(), style.Wait();
    return absl::OkStatus();
  });
  EXPECT_TRUE(Run(stages, NewJob("j1")).status.ok());
}

TEST_F(PipelineTest, DrawsFurtherViewsBesideThePreview) {
  FakeStages stages;
  v1::Job job = NewJob("j1");
  job.mutable_spec()->add_further_views()->set_view(v1::PREVIEW_VIEW_BIRDSEYE);
  job.mutable_spec()->add_further_views()->set_size_px(300);
  ASSERT_TRUE(Run(stages, job).status.ok());
  EXPECT_EQ(stages.calls("Render"), 3);
  std::vector<int> kinds;
  const v1::Job made = pipeline_.Get("j1");
  for (const v1::ArtifactRef& ref : made.artifacts()) kinds.push_back(ref.kind());
  EXPECT_THAT(kinds,
              ElementsAre(1, 2, 3, 4, 5, 6, 7, 12, 8, 9, 10, 11, v1::ARTIFACT_KIND_PREVIEW, v1::ARTIFACT_KIND_PREVIEW));
  // Another job that asks for one of them gets it without drawing.
  v1::Job other = NewJob("j2");
  *other.mutable_spec()->add_further_views() = job.spec().further_views(0);
  ASSERT_TRUE(Run(stages, other).status.ok());
  EXPECT_EQ(stages.calls("Render"), 3);
}

TEST_F(PipelineTest, ReportsMetricsOutcomesAndRemarks) {
  FakeStages stages;
  ASSERT_TRUE(Run(stages, NewJob("j1")).status.ok());
  const v1::Artifact artifact = pipeline_.Artifact(Ids("j1", true).back());
  const v1::Report& report = artifact.report();
  EXPECT_EQ(report.job_id(), "j1");
  EXPECT_EQ(report.metrics().oob_percent(), 0.5);
  EXPECT_EQ(report.constraints().satisfied_count(), 1);
  EXPECT_EQ(report.constraints().untranslated_count(), 0);
  ASSERT_THAT(report.diagnostics(), SizeIs(1));
  EXPECT_EQ(report.diagnostics(0).code(), "assumed_door");
}

}  // namespace
}  // namespace flair::orchestrator
