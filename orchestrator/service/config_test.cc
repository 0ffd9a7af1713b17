// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "flair/config/v1/language_worker_config.pb.h"
#include "flair/config/v1/optimizer_worker_config.pb.h"
#include "flair/config/v1/renderer_worker_config.pb.h"
#include "flair/config/v1/translator_worker_config.pb.h"
#include "orchestrator/service/make_orchestrator_service.h"

namespace flair::orchestrator {
namespace {

template <typename Config>
Config Load(const std::string& path) {
  Config config;
  const absl::Status status = runtime::ReadConfigFile(FLAIR_SOURCE_DIR "/orchestrator/" + path, config, nullptr);
  EXPECT_TRUE(status.ok()) << status;
  return config;
}

TEST(Config, OfTheOrchestratorIsGood) {
  for (const std::string path : {"config.textproto", "compose/orchestrator.textproto"}) {
    config::v1::OrchestratorConfig config;
    const absl::Status status =
        runtime::ReadConfigFile(FLAIR_SOURCE_DIR "/orchestrator/" + path, config,
                                [&](runtime::ConfigChecker& checker) { CheckOrchestratorConfig(config, checker); });
    EXPECT_TRUE(status.ok()) << status;
    EXPECT_TRUE(ConnectStages(config).ok());
  }
}

TEST(Config, OfEveryContainerIsGood) {
  EXPECT_EQ(Load<config::v1::LanguageWorkerConfig>("compose/language.textproto").runtime().listen_address(),
            "0.0.0.0:50051");
  EXPECT_EQ(Load<config::v1::TranslatorWorkerConfig>("compose/translator.textproto").optimizer_address(),
            "dns:///optimizer:50053");
  Load<config::v1::OptimizerWorkerConfig>("compose/optimizer.textproto");
  Load<config::v1::RendererWorkerConfig>("compose/renderer.textproto");
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
