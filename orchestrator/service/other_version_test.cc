// SPDX-License-Identifier: GPL-3.0-or-later
// Jobs whose stages are servers of another version, or of something else, behind real sockets.
#include <gmock/gmock.h>

#include "orchestrator/testing/embedded_for_test.h"
#include "orchestrator/testing/fake_workers.h"
#include "orchestrator/testing/temporary_folder.h"
#include "tests/fixtures/worker_speaker.h"

namespace flair::orchestrator {
namespace {

using ::testing::HasSubstr;

// How a job ends whose language stage is at that address.
v1::Job EndOf(const std::string& address) {
  TemporaryFolder folder;
  config::v1::OrchestratorConfig config;
  config.set_store_path(folder.path());
  config.mutable_runtime()->set_log_level("error");
  config.mutable_stages()->set_language(address);
  config.mutable_stages()->set_translator(address);
  config.mutable_stages()->set_optimizer(address);
  config.mutable_stages()->set_renderer(address);
  EmbeddedForTest orchestrator(config, *ConnectStages(config));
  v1::JobSpec spec;
  spec.mutable_brief()->set_text("A bedroom.");
  const v1::Job job = *orchestrator.CreateJob("r1", spec);
  orchestrator.Watch(job.id());
  return *orchestrator.GetJob(job.id());
}

TEST(OtherVersion, EndsTheJobWithASentence) {
  const flair::testing::WorkerSpeaker speaker("their-program", {"flair.v2", "flair.v3"});
  const v1::Job job = EndOf(speaker.address());
  EXPECT_EQ(job.state(), v1::JOB_STATE_FAILED);
  EXPECT_EQ(job.stage(), "room");
  EXPECT_EQ(job.error_code(), static_cast<int>(absl::StatusCode::kUnimplemented));
  EXPECT_EQ(job.error(), "language worker at " + speaker.address() +
                             ": their-program speaks flair.v2, flair.v3, this program flair.v1; start a version of it "
                             "that does or fix stages.language");
}

TEST(OtherVersion, WordsOfOthersAreCutShortAndPrintable) {
  const flair::testing::WorkerSpeaker speaker("their-program",
                                              {std::string(100000, 'x') + "\x1b[2J", "\x1b[2J", "c", "d", "e"});
  const std::string error = EndOf(speaker.address()).error();
  EXPECT_LT(error.size(), 400u);
  EXPECT_THAT(error, HasSubstr(", ?[2J, c, d, ..., this program flair.v1"));
}

TEST(OtherVersion, AServerOfSomethingElseEndsTheJobWithASentence) {
  for (const std::vector<std::string>& protocols :
       {std::vector<std::string>{}, std::vector<std::string>{"flair.v2", "flair.v1"}}) {
    const flair::testing::WorkerSpeaker speaker("their-program", protocols);
    const v1::Job job = EndOf(speaker.address());
    EXPECT_EQ(job.error_code(), static_cast<int>(absl::StatusCode::kUnimplemented));
    EXPECT_THAT(job.error(), HasSubstr("language worker at " + speaker.address() +
                                       ": the server there does not serve this call of flair.v1.LanguageService"));
    EXPECT_THAT(job.error(), HasSubstr("start one that does or fix stages.language"));
  }
}

}  // namespace
}  // namespace flair::orchestrator
