// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

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
  EXPECT_EQ(Load<config::v1::OptimizerWorkerConfig>("compose/optimizer.textproto").peer_addresses(0),
            "dns:///restarts:50055");
  EXPECT_EQ(Load<config::v1::OptimizerWorkerConfig>("compose/restarts.textproto").runtime().listen_address(),
            "0.0.0.0:50055");
  Load<config::v1::RendererWorkerConfig>("compose/renderer.textproto");
}

std::string ReadText(const std::string& path) {
  std::ifstream file(FLAIR_SOURCE_DIR "/" + path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(Config, EveryNameThatAContainerLooksForIsAServiceThatListensThere) {
  const std::string compose = ReadText("compose.yaml");
  ASSERT_FALSE(compose.empty());
  size_t names = 0;
  for (const auto& entry : std::filesystem::directory_iterator(FLAIR_SOURCE_DIR "/orchestrator/compose")) {
    const std::string file = "orchestrator/compose/" + entry.path().filename().string();
    EXPECT_THAT(compose, ::testing::HasSubstr("./" + file + ":/etc/flair/config.textproto:ro")) << "is mounted nowhere";
    const std::string text = ReadText(file);
    const std::regex address("\"dns:///([a-z]+):([0-9]+)\"");
    for (std::sregex_iterator it(text.begin(), text.end(), address), end; it != end; ++it, ++names) {
      const std::string name = (*it)[1], port = (*it)[2];
      EXPECT_THAT(compose, ::testing::HasSubstr("\n  " + name + ":\n")) << file;
      EXPECT_THAT(ReadText("orchestrator/compose/" + name + ".textproto"),
                  ::testing::HasSubstr("listen_address: \"0.0.0.0:" + port + "\""))
          << file;
    }
  }
  EXPECT_GE(names, 7u);
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
