// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "orchestrator/service/make_orchestrator_service.h"

namespace flair::orchestrator {
namespace {

// Those of containers too, which tests/deploy runs.
TEST(Config, OfTheOrchestratorIsGood) {
  for (const std::string path : {"orchestrator/config.textproto", "deploy/config/orchestrator.textproto",
                                 "deploy/config/three_node/orchestrator.textproto"}) {
    config::v1::OrchestratorConfig config;
    const absl::Status status =
        runtime::ReadConfigFile(FLAIR_SOURCE_DIR "/" + path, config,
                                [&](runtime::ConfigChecker& checker) { CheckOrchestratorConfig(config, checker); });
    EXPECT_TRUE(status.ok()) << status;
  }
}

TEST(Config, ReportsEveryMissingField) {
  config::v1::OrchestratorConfig config;
  const absl::Status status =
      runtime::ReadConfigText("c", "running_job_limit: -1\nstages { language: \"a:1\" }", config,
                              [&](runtime::ConfigChecker& checker) { CheckOrchestratorConfig(config, checker); });
  const std::string message(status.message());
  for (const char* field :
       {"store_path", "c:1: running_job_limit", "stages.translator", "stages.optimizer", "stages.renderer"}) {
    EXPECT_THAT(message, ::testing::HasSubstr(field));
  }
  EXPECT_THAT(message, ::testing::Not(::testing::HasSubstr("stages.language")));
}

}  // namespace
}  // namespace flair::orchestrator
