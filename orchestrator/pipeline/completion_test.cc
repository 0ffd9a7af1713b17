// SPDX-License-Identifier: GPL-3.0-or-later
// Jobs whose constraints nobody completes.
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

}  // namespace
}  // namespace flair::orchestrator
