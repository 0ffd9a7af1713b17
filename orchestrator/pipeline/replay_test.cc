// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "orchestrator/pipeline/stage.h"
#include "orchestrator/testing/fake_stages.h"
#include "orchestrator/testing/pipeline_for_test.h"

namespace flair::orchestrator {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class ReplayTest : public ::testing::Test {
 protected:
  v1::Job NewJob(const std::string& id, const v1::JobSpec& spec) {
    v1::Job job;
    job.set_id(id);
    *job.mutable_spec() = spec;
    return job;
  }
  v1::Job First(const std::string& id = "first") {
    v1::JobSpec spec;
    spec.mutable_brief()->set_text("A bedroom.");
    spec.mutable_brief()->set_seed(3);
    return NewJob(id, spec);
  }
  v1::JobSpec SpecOfReplay(const std::string& of, const std::string& from) {
    v1::JobSpec spec = pipeline_.Get(of).spec();
    spec.mutable_replay()->set_job_id(of);
    spec.mutable_replay()->set_from_stage(from);
    return spec;
  }

  PipelineResult Run(FakeStages& stages, const v1::Job& job) { return pipeline_.Run(stages, job); }
  // The id of the artifact that a stage has in a job; empty when it has none.
  std::string IdOf(const std::string& job_id, const std::string& stage) {
    const v1::Job job = pipeline_.Get(job_id);
    for (const v1::ArtifactRef& ref : job.artifacts()) {
      if (ref.kind() == Stages()[static_cast<size_t>(StageIndex(stage))].output) return ref.id();
    }
    return "";
  }
  // As "solve" for a stage that was run and "=room" for one whose artifact was taken.
  std::vector<std::string> WhatHappened(const std::string& job) {
    std::vector<std::string> told;
    for (const v1::JobEvent& event : pipeline_.Events(job)) {
      if (event.kind() == v1::JOB_EVENT_KIND_STAGE_FINISHED) told.push_back(event.stage());
      if (event.kind() == v1::JOB_EVENT_KIND_STAGE_REUSED) told.push_back("=" + event.stage());
    }
    std::sort(told.begin(), told.end());
    return told;
  }

  PipelineForTest pipeline_;
};

TEST_F(ReplayTest, OfAWholeJobMakesEverythingAnewAndGetsTheSameBytes) {
  FakeStages stages;
  ASSERT_TRUE(Run(stages, First()).status.ok());
  FakeStages again;
  ASSERT_TRUE(Run(again, NewJob("again", SpecOfReplay("first", ""))).status.ok());
  EXPECT_EQ(again.all_calls(), stages.all_calls());
  EXPECT_EQ(WhatHappened("again"), WhatHappened("first"));
  for (const Stage& stage : Stages()) {
    const std::string name(stage.name);
    if (name != "report") {
      EXPECT_EQ(IdOf("again", name), IdOf("first", name)) << name;
    }
  }
}

TEST_F(ReplayTest, FromAStageTakesWhatTheEarlierJobHadBeforeIt) {
  FakeStages stages;
  ASSERT_TRUE(Run(stages, First()).status.ok());
  FakeStages again;
  ASSERT_TRUE(Run(again, NewJob("again", SpecOfReplay("first", "solve"))).status.ok());
  EXPECT_THAT(WhatHappened("again"),
              ElementsAre("=brief", "=cleaning", "=completion", "=constraints", "=objects", "=room", "=style",
                          "=translation", "=zones", "render", "report", "solve"));
  EXPECT_EQ(again.all_calls(), 3);
  EXPECT_EQ(IdOf("again", "solve"), IdOf("first", "solve"));
}

TEST_F(ReplayTest, TakesArtifactsThatNobodyWouldMakeAgain) {
  FakeStages stages;
  ASSERT_TRUE(Run(stages, First()).status.ok());
  stages.set_revision("another");
  ASSERT_TRUE(Run(stages, NewJob("again", SpecOfReplay("first", "render"))).status.ok());
  EXPECT_EQ(IdOf("again", "solve"), IdOf("first", "solve"));
  EXPECT_EQ(stages.calls("Solve"), 1);
}

TEST_F(ReplayTest, ThatWasInterruptedGoesOnFromItsOwnArtifacts) {
  FakeStages stages;
  ASSERT_TRUE(Run(stages, First()).status.ok());
  FakeStages broken([](std::string_view rpc, runtime::CallContext&) {
    return rpc == "Solve" ? absl::InternalError("power cut") : absl::OkStatus();
  });
  const v1::Job again = NewJob("again", SpecOfReplay("first", "objects"));
  ASSERT_FALSE(Run(broken, again).status.ok());
  FakeStages rest;
  ASSERT_TRUE(Run(rest, again).status.ok());
  EXPECT_EQ(rest.calls("ListObjects"), 0);
  EXPECT_EQ(rest.calls("Translate"), 0);
  EXPECT_EQ(rest.calls("Solve"), 1);
  EXPECT_THAT(WhatHappened("again"), ElementsAre("=brief", "=room", "=zones", "cleaning", "completion", "constraints",
                                                 "objects", "render", "report", "solve", "style", "translation"));
}

TEST_F(ReplayTest, IsNeitherUsedByOtherJobsNorReplacesWhatTheyUse) {
  FakeStages stages;
  ASSERT_TRUE(Run(stages, First()).status.ok());
  FakeStages other;
  other.set_seed_added(5);
  ASSERT_TRUE(Run(other, NewJob("again", SpecOfReplay("first", "solve"))).status.ok());
  ASSERT_NE(IdOf("again", "solve"), IdOf("first", "solve"));
  FakeStages none;
  ASSERT_TRUE(Run(none, First("third")).status.ok());
  EXPECT_EQ(none.calls("Solve"), 0);
  EXPECT_EQ(IdOf("third", "solve"), IdOf("first", "solve"));
}

TEST_F(ReplayTest, OfAReplayTakesWhatThatHad) {
  FakeStages stages;
  ASSERT_TRUE(Run(stages, First()).status.ok());
  ASSERT_TRUE(Run(stages, NewJob("second", SpecOfReplay("first", "solve"))).status.ok());
  ASSERT_TRUE(Run(stages, NewJob("third", SpecOfReplay("second", "render"))).status.ok());
  EXPECT_EQ(IdOf("third", "room"), IdOf("first", "room"));
  EXPECT_EQ(stages.calls("Solve"), 2);
}

TEST_F(ReplayTest, SaysWhichArtifactIsGoneOrDamaged) {
  FakeStages stages;
  ASSERT_TRUE(Run(stages, First()).status.ok());
  const std::string path = pipeline_.PathOf(IdOf("first", "objects"));
  std::ofstream(path, std::ios::trunc) << "damaged";
  const PipelineResult damaged = Run(stages, NewJob("second", SpecOfReplay("first", "solve")));
  EXPECT_EQ(damaged.status.code(), absl::StatusCode::kDataLoss);
  EXPECT_EQ(damaged.stage, "objects");
  std::filesystem::remove(path);
  const PipelineResult gone = Run(stages, NewJob("third", SpecOfReplay("first", "solve")));
  EXPECT_EQ(gone.status.code(), absl::StatusCode::kNotFound);
  EXPECT_THAT(std::string(gone.status.message()),
              HasSubstr("it should have come from job first: run that job again from \"objects\" or an earlier stage"));
}

TEST_F(ReplayTest, IsRefusedWhenItCannotBeDone) {
  FakeStages broken([](std::string_view rpc, runtime::CallContext&) {
    return rpc == "ListObjects" ? absl::InternalError("out of ideas") : absl::OkStatus();
  });
  ASSERT_FALSE(Run(broken, First()).status.ok());
  const auto check = [&](const std::string& from, const std::string& text) {
    v1::JobSpec spec = SpecOfReplay("first", from);
    if (!text.empty()) spec.mutable_brief()->set_text(text);
    return CheckReplay(spec, pipeline_.Get("first"));
  };
  EXPECT_EQ(check("objects", ""), absl::OkStatus());
  EXPECT_EQ(check("", "A kitchen."), absl::OkStatus());
  EXPECT_EQ(check("brief", "A kitchen."), absl::OkStatus());
  EXPECT_THAT(std::string(check("sole", "").message()),
              HasSubstr("spec.replay.from_stage: there is no stage \"sole\"; one of brief, room, zones"));
  const absl::Status brief = check("room", "A kitchen.");
  EXPECT_EQ(brief.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(brief.message()), HasSubstr("spec.brief: is not the brief of job first"));
  const absl::Status too_late = check("solve", "");
  EXPECT_EQ(too_late.code(), absl::StatusCode::kFailedPrecondition);
  EXPECT_THAT(std::string(too_late.message()), HasSubstr("job first has no artifact of the stage \"objects\""));
}

// The names of the stages of which other results are asked.
std::vector<std::string> Differing(const v1::JobSpec& first, const v1::JobSpec& second) {
  std::vector<std::string> names;
  const std::vector<bool> differ = StagesAskedToDiffer(first, second);
  for (size_t i = 0; i < differ.size(); ++i) {
    if (differ[i]) names.emplace_back(Stages()[i].name);
  }
  return names;
}

TEST(StagesAskedToDiffer, FollowsTheInputs) {
  v1::JobSpec first;
  v1::JobSpec second;
  second.mutable_solve_options()->set_thread_count(3);
  EXPECT_THAT(Differing(first, second), ElementsAre());
  second.mutable_render_options()->set_size_px(512);
  EXPECT_THAT(Differing(first, second), ElementsAre("render", "report"));
  second.mutable_solve_options()->set_max_restart_count(3);
  EXPECT_THAT(Differing(first, second), ElementsAre("solve", "render", "report"));
  second.mutable_model_options()->mutable_budget()->set_call_count(3);
  EXPECT_THAT(Differing(first, second), ElementsAre("solve", "render", "report"));
  second.mutable_brief()->set_seed(3);
  EXPECT_THAT(Differing(first, second), ::testing::SizeIs(12));
  first.add_further_views();
  EXPECT_THAT(Differing(first, second), ::testing::SizeIs(13));
}

}  // namespace
}  // namespace flair::orchestrator
