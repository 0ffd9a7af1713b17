// SPDX-License-Identifier: GPL-3.0-or-later
// Jobs whose constraints nobody completes, and answers that are none.
#include <gmock/gmock.h>
#include <google/protobuf/util/time_util.h>

#include <filesystem>
#include <fstream>

#include "orchestrator/pipeline/pipeline.h"
#include "orchestrator/pipeline/stage.h"
#include "orchestrator/testing/fake_stages.h"
#include "orchestrator/testing/pipeline_for_test.h"
#include "worker_runtime/testing/fakes.h"

namespace flair::orchestrator {
namespace {

v1::Job NewJob(const std::string& id) {
  v1::Job job;
  job.set_id(id);
  job.mutable_spec()->mutable_brief()->set_text("A bedroom.");
  return job;
}

TEST(Completion, WithoutItTheListGoesOnAsItIs) {
  PipelineForTest pipeline;
  FakeStages unable([](std::string_view rpc, runtime::CallContext&) {
    return rpc == "CompleteConstraints" ? absl::UnimplementedError("not here") : absl::OkStatus();
  });
  ASSERT_TRUE(pipeline.Run(unable, NewJob("j1")).status.ok());
  FakeStages stages;
  v1::Job refused = NewJob("j2");
  refused.mutable_spec()->set_no_completion(true);
  ASSERT_TRUE(pipeline.Run(stages, refused).status.ok());
  EXPECT_EQ(stages.calls("CompleteConstraints"), 0);
  for (const char* const job : {"j1", "j2"}) {
    const v1::ConstraintList cleaned = pipeline.Artifact(pipeline.Get(job).artifacts(6).id()).constraint_list();
    v1::ConstraintList completed = pipeline.Artifact(pipeline.Get(job).artifacts(7).id()).completed_constraint_list();
    ASSERT_EQ(completed.diagnostics_size(), cleaned.diagnostics_size() + 1) << job;
    EXPECT_EQ(completed.diagnostics().rbegin()->code(), "not_completed");
    completed.mutable_diagnostics()->RemoveLast();
    EXPECT_EQ(completed.SerializeAsString(), cleaned.SerializeAsString()) << job;
  }
}

// Describes rooms without a floor, and places nothing, as it is told.
class WrongStages : public FakeStages {
 public:
  // Workers of language that do so; those that are asked after them do not.
  int wrong_rooms = 0;
  // The same of optimizers that evaluate nothing.
  int wrong_evaluations = 0;
  bool nothing_placed = false;

  absl::StatusOr<v1::DescribeRoomResponse> DescribeRoom(const v1::DescribeRoomRequest& request, Call& call) override {
    auto response = FakeStages::DescribeRoom(request, call);
    response->mutable_producer()->set_program("their-language");
    const auto asked = static_cast<int>(call.bad_answerers().size());
    if (asked < wrong_rooms) response->mutable_room()->clear_floor();
    call.SetAnswerer({"1", asked});
    return response;
  }
  absl::StatusOr<v1::EvaluateResponse> Evaluate(const v1::EvaluateRequest& request, Call& call) override {
    auto response = FakeStages::Evaluate(request, call);
    const auto asked = static_cast<int>(call.bad_answerers().size());
    if (asked < wrong_evaluations) response->Clear();
    call.SetAnswerer({"1", asked});
    return response;
  }
  absl::StatusOr<v1::SolveResponse> Solve(const v1::SolveRequest& request, Call& call) override {
    auto response = FakeStages::Solve(request, call);
    if (nothing_placed) response->mutable_solved_layout()->clear_placements();
    return response;
  }
};

TEST(BadAnswers, AreAskedOfAnotherWorker) {
  PipelineForTest pipeline;
  WrongStages stages;
  stages.wrong_rooms = stages.wrong_evaluations = 1;
  EXPECT_TRUE(pipeline.Run(stages, NewJob("j1")).status.ok());
  EXPECT_EQ(stages.calls("DescribeRoom"), 2);
  EXPECT_EQ(stages.calls("Evaluate"), 2);
}

TEST(BadAnswers, OfTwoWorkersEndTheRunAndSayWhose) {
  PipelineForTest pipeline;
  WrongStages stages;
  stages.wrong_rooms = 2;
  const absl::Status status = pipeline.Run(stages, NewJob("j1")).status;
  EXPECT_EQ(status.code(), absl::StatusCode::kInternal);
  EXPECT_THAT(std::string(status.message()), ::testing::HasSubstr("the answer of their-language is not valid"));
  EXPECT_THAT(std::string(status.message()), ::testing::HasSubstr("room.floor"));
}

TEST(BadAnswers, ALayoutOfNothingIsOne) {
  PipelineForTest pipeline;
  WrongStages stages;
  stages.nothing_placed = true;
  const absl::Status status = pipeline.Run(stages, NewJob("j1")).status;
  EXPECT_EQ(status.code(), absl::StatusCode::kInternal);
  EXPECT_THAT(std::string(status.message()), ::testing::HasSubstr("placements: there are none"));
}

}  // namespace
}  // namespace flair::orchestrator
