// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/service/make_language_service.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <utility>

#include "flair/v1/language_service.grpc.pb.h"
#include "language_worker/model/model_handlers.h"
#include "language_worker/service/testing/model_session.h"
#include "llm/testing/fake_llm_client.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/grpc/in_process_server.h"

namespace flair::language {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// A service that asks `model` in the place of the configured one.
auto ServiceWith(std::unique_ptr<llm::LlmClient> model, config::v1::LanguageWorkerConfig config,
                 runtime::WorkerContext& context) {
  config.mutable_llm();
  return MakeLanguageService(config, context,
                             [&](const auto& made, const Handbook& handbook, runtime::WorkerContext& worker) {
                               return MakeModelHandlers(std::move(model), made, handbook, worker);
                             });
}

std::string RevisionOf(const config::v1::LanguageWorkerConfig& config, bool with_model) {
  runtime::WorkerResources resources("flair-language", {});
  const auto service = with_model ? ServiceWith(std::make_unique<llm::FakeLlmClient>(), config, resources.context())
                                  : MakeLanguageService(config, resources.context());
  EXPECT_TRUE(service.ok()) << service.status();
  return resources.context().revision;
}

TEST(MakeLanguageService, TheRevisionNamesHandbookModelAndPrompts) {
  const config::v1::LanguageWorkerConfig config;
  const std::string handbook = RevisionOf(config, /*with_model=*/false);
  EXPECT_EQ(handbook, ModelSession::handbook().version());
  const std::string model = RevisionOf(config, /*with_model=*/true);
  EXPECT_THAT(model, HasSubstr(handbook));
  EXPECT_THAT(model, HasSubstr("fake-1"));
  const std::filesystem::path own = std::filesystem::path(::testing::TempDir()) / "language_prompts";
  std::filesystem::create_directories(own);
  std::ofstream(own / "room.txt") << "Describe {{brief}} in another way.";
  config::v1::LanguageWorkerConfig other;
  other.mutable_llm()->set_prompts_path(own.string());
  EXPECT_NE(RevisionOf(other, /*with_model=*/true), model);
  std::ofstream(own / "room.txt") << "Describe {{breif}} in another way.";
  runtime::WorkerResources resources("flair-language", {});
  const auto service = ServiceWith(std::make_unique<llm::FakeLlmClient>(), other, resources.context());
  EXPECT_THAT(service.status().message(), HasSubstr("room.txt:1: {{breif}} is not a placeholder of this prompt"));
  std::filesystem::remove_all(own);
}

TEST(MakeLanguageService, AnswersWithTheModelOverTheWire) {
  auto model = std::make_unique<llm::FakeLlmClient>();
  model->Answer("room", GoodAnswers().at("room"));
  auto server = runtime::InProcessServer::Start(
      "flair-language", {}, v1::LanguageService::service_full_name(),
      [&](runtime::WorkerContext& context) { return ServiceWith(std::move(model), {}, context); });
  ASSERT_TRUE(server.ok()) << server.status();
  const auto stub = v1::LanguageService::NewStub((*server)->channel());
  v1::DescribeRoomRequest request;
  request.mutable_brief()->set_text("A bedroom that is 4m x 5m.");
  runtime::CallContext call;
  const auto room = runtime::UnaryRequest<v1::LanguageService::Stub, v1::LanguageService::StubInterface,
                                          v1::DescribeRoomRequest, v1::DescribeRoomResponse>(
      *stub, &v1::LanguageService::StubInterface::DescribeRoom, request, call);
  ASSERT_TRUE(room.ok()) << room.status();
  EXPECT_EQ(room->producer().method(), "fake-1");
  EXPECT_EQ(room->room().room_type(), "bedroom");
  EXPECT_EQ(room->model_calls_size(), 1);
}

TEST(MakeLanguageService, AConfigThatCannotWorkIsRefusedByItsFields) {
  config::v1::LanguageWorkerConfig config;
  config.mutable_llm()->set_base_url("ftp://nowhere");
  runtime::WorkerResources resources("flair-language", {});
  const auto with_model = [](const auto& made, const Handbook& handbook, runtime::WorkerContext& worker) {
    return MakeModelHandlers(made, handbook, worker);
  };
  EXPECT_FALSE(MakeLanguageService(config, resources.context(), with_model).ok());
}

TEST(MakeLanguageService, AProgramWithoutModelsRefusesAConfigThatHasOne) {
  config::v1::LanguageWorkerConfig config;
  config.mutable_llm()->set_model("gpt-4o");
  runtime::WorkerResources resources("flair-language", {});
  EXPECT_THAT(MakeLanguageService(config, resources.context()).status().message(),
              HasSubstr("llm: this program asks no language model"));
}

}  // namespace
}  // namespace flair::language
