// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "cli/exit_code.h"
#include "cli/session/session.h"

namespace flair::cli {
namespace {

v1::Job FailedAt(const std::string& stage, absl::StatusCode code, v1::FailureKind kind) {
  v1::Job job;
  job.set_state(v1::JOB_STATE_FAILED);
  job.set_stage(stage);
  job.set_error("why");
  job.set_error_code(static_cast<int>(code));
  job.set_failure_kind(kind);
  return job;
}

TEST(ErrorOf, AnswersOfNoUseAreTheModels) {
  for (const char* stage : {"room", "zones", "cleaning", "translation"}) {
    const v1::Job job = FailedAt(stage, absl::StatusCode::kDataLoss, v1::FAILURE_KIND_LANGUAGE);
    EXPECT_EQ(ExitCodeOf(ErrorOf(job)), kExitModel) << stage;
  }
  EXPECT_EQ(ExitCodeOf(ErrorOf(FailedAt("solve", absl::StatusCode::kDataLoss, v1::FAILURE_KIND_WORKER))), kExitCorrupt);
}

TEST(ErrorOf, WhatIsDamagedInTheStoreIsNoModelsFault) {
  for (const char* stage : {"room", "zones", "cleaning", "translation", "solve", ""}) {
    const v1::Job job = FailedAt(stage, absl::StatusCode::kDataLoss, v1::FAILURE_KIND_STORE);
    EXPECT_EQ(ExitCodeOf(ErrorOf(job)), kExitCorrupt) << stage;
    EXPECT_EQ(ErrorOf(job).message(), "why");
  }
}

TEST(ErrorOf, WhatIsTakenFromAnEarlierJobIsNoModelsFault) {
  v1::Job job = FailedAt("zones", absl::StatusCode::kDataLoss, v1::FAILURE_KIND_LANGUAGE);
  job.mutable_spec()->mutable_replay()->set_from_stage("solve");
  EXPECT_EQ(ExitCodeOf(ErrorOf(job)), kExitCorrupt);
  job.set_stage("translation");
  job.mutable_spec()->mutable_replay()->set_from_stage("zones");
  EXPECT_EQ(ExitCodeOf(ErrorOf(job)), kExitModel);
}

}  // namespace
}  // namespace flair::cli
