// SPDX-License-Identifier: GPL-3.0-or-later
// What the client sends, and what it takes for an answer.
#include "llm/openai/openai_client.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "llm/testing/test_openai_client.h"

namespace flair::llm {
namespace {

using absl::StatusCode;
using ::flair::testing::LoadScript;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;

TEST_F(OpenAiClientTest, SendsTheQuestionAsTheProtocolWantsIt) {
  options_.config.set_temperature(0.2);
  options_.config.set_seed(7);
  Serve("answer");
  ASSERT_TRUE(Ask().ok());
  const json expected = {
      {"model", "some-model"},
      {"messages",
       json::array({{{"role", "system"}, {"content", "You divide rooms into zones."}},
                    {{"role", "user"}, {"content", "The brief: \"a bedroom for a deep-sea diver, 4 by 3 metres\""}}})},
      {"response_format",
       {{"type", "json_schema"},
        {"json_schema", {{"name", "zones"}, {"strict", true}, {"schema", json::parse(ZonesRequest().schema)}}}}},
      {"temperature", 0.2},
      {"seed", 7},
      {"max_tokens", 4096}};
  EXPECT_EQ(Sent(0), expected);
  const auto request = server_->requests().front();
  EXPECT_EQ(request.target, "/v1/chat/completions");
  EXPECT_EQ(request.header("authorization"), "Bearer sk-0123456789abcdef");
  EXPECT_EQ(request.header("content-type"), "application/json");
}

TEST_F(OpenAiClientTest, KeepsTheOrderOfTheSchemasFields) {
  Serve("answer");
  ASSERT_TRUE(Ask().ok());
  const std::string body = server_->requests().front().body;
  EXPECT_THAT(body, HasSubstr(R"("properties":{"zones":{"type":"array"},"about":{"type":"string"}})"));
}

TEST_F(OpenAiClientTest, AsksForFreeTextWithoutASchema) {
  Serve("answer");
  ChatRequest request = ZonesRequest();
  request.schema.clear();
  request.schema_name.clear();
  request.max_output_token_count = 50;
  ASSERT_TRUE(Ask(request).ok());
  EXPECT_FALSE(Sent(0).contains("response_format"));
  EXPECT_EQ(Sent(0)["max_tokens"], 50);
}

TEST_F(OpenAiClientTest, AsksForTheUsageOfAStream) {
  options_.config.set_stream(true);
  Serve("answer");
  const auto answer = Ask();
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_EQ(Sent(0)["stream"], true);
  EXPECT_EQ(Sent(0)["stream_options"], (json{{"include_usage", true}}));
  EXPECT_FALSE(answer->usage.estimated);
  EXPECT_EQ(answer->usage.cached_input_token_count, 3);
}

TEST_F(OpenAiClientTest, TellsUsageAndModelAsTheServerDoes) {
  auto script = LoadScript("answer");
  script.exchanges.front().answer.update(
      {{"prompt_tokens", 120}, {"completion_tokens", 34}, {"cached_tokens", 100}, {"model", "some-model-2024-08-06"}});
  Serve(script);
  const auto answer = Ask();
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_EQ(answer->usage.input_token_count, 120);
  EXPECT_EQ(answer->usage.output_token_count, 34);
  EXPECT_EQ(answer->usage.cached_input_token_count, 100);
  EXPECT_EQ(answer->model, "some-model-2024-08-06");
}

TEST_F(OpenAiClientTest, KnowsAzuresPathAndHeader) {
  Serve("answer");
  options_.config.set_base_url(server_->address() + "/");
  options_.config.mutable_azure()->set_deployment("rooms/1");
  options_.config.mutable_azure()->set_api_version("2024-10-21");
  ASSERT_TRUE(Ask().ok());
  const auto request = server_->requests().front();
  EXPECT_EQ(request.target, "/openai/deployments/rooms%2F1/chat/completions?api-version=2024-10-21");
  EXPECT_EQ(request.header("api-key"), "sk-0123456789abcdef");
  EXPECT_EQ(request.header("authorization"), "");
}

TEST_F(OpenAiClientTest, SendsHeadersOfTheUsersOwn) {
  options_.api_key.clear();
  options_.headers = {{"X-Team", "rooms"}, {"User-Agent", "mine"}};
  Serve("answer");
  ASSERT_TRUE(Ask().ok());
  const auto request = server_->requests().front();
  EXPECT_EQ(request.header("x-team"), "rooms");
  EXPECT_EQ(request.header("user-agent"), "mine");
  EXPECT_EQ(request.header("authorization"), "");
}

TEST_F(OpenAiClientTest, AnAnswerThatTheServerTookForThoughtsIsTheAnswer) {
  auto script = LoadScript("answer");
  for (const char* name : {"reasoning_content", "reasoning"}) {
    script.exchanges.front().answer = nullptr;
    script.exchanges.front().body =
        json{{"choices", {{{"message", {{"content", nullptr}, {name, kBedroom}}}, {"finish_reason", "STOP"}}}}}.dump();
    Serve(script);
    const auto answer = Ask();
    ASSERT_TRUE(answer.ok()) << answer.status();
    EXPECT_EQ(answer->text, kBedroom);
  }
}

TEST_F(OpenAiClientTest, SendsTheRequestsSeedUnlessItHasItsOwn) {
  Serve("answer");
  ChatRequest request = ZonesRequest();
  ASSERT_TRUE(Ask(request).ok());
  request.seed = 9007199254740991;
  ASSERT_TRUE(Ask(request).ok());
  EXPECT_EQ(Sent(0)["seed"], 0);
  EXPECT_EQ(Sent(1)["seed"], 9007199254740991);
  options_.config.set_seed(5);
  Serve("answer");
  ASSERT_TRUE(Ask(request).ok());
  EXPECT_EQ(Sent(0)["seed"], 5);
}

TEST_F(OpenAiClientTest, TakesTheWholeAddressToo) {
  Serve("answer");
  options_.config.mutable_base_url()->append("/chat/completions");
  ASSERT_TRUE(Ask().ok());
  EXPECT_EQ(server_->requests().front().target, "/v1/chat/completions");
}

TEST_F(OpenAiClientTest, AnErrorThatQuotesThePromptIsNotShown) {
  auto script = LoadScript("answer");
  script.exchanges.front() = {};
  script.exchanges.front().status = 404;
  script.exchanges.front().body = R"({"error":{"message":"cannot: a bedroom for a deep-sea diver, 4 by"}})";
  Serve(script);
  const auto status = Ask().status();
  EXPECT_EQ(status.code(), StatusCode::kNotFound);
  EXPECT_THAT(status.message(), Not(HasSubstr("diver")));
}

TEST_F(OpenAiClientTest, AnErrorThatQuotesASecretHeaderIsNotShown) {
  options_.headers = {{"X-Gateway-Key", "gateway-secret"}};
  auto script = LoadScript("answer");
  script.exchanges.front() = {};
  script.exchanges.front().status = 503;
  script.exchanges.front().body = R"({"error":{"message":"overloaded","code":"for_gateway-secret"}})";
  Serve(script);
  const auto status = Ask().status();
  EXPECT_EQ(status.code(), StatusCode::kUnavailable);
  EXPECT_THAT(status.message(), HasSubstr("overloaded"));
  EXPECT_THAT(status.message(), Not(HasSubstr("gateway-secret")));
}

TEST_F(OpenAiClientTest, ItsIdentityHoldsWhatDecidesTheAnswersAndNoSecret) {
  options_.config.set_base_url("https://user:password@gateway.example/v1?token=token-1");
  options_.headers = {{"X-Gateway-Key", "gateway-secret"}};
  options_.config.set_temperature(0.25);
  const std::string identity = client().identity();
  EXPECT_THAT(identity, HasSubstr("https://gateway.example/v1"));
  EXPECT_THAT(identity, HasSubstr("some-model"));
  EXPECT_THAT(identity, HasSubstr("0.25"));
  for (const char* secret : {"sk-", "password", "token-1", "gateway-secret"})
    EXPECT_THAT(identity, Not(HasSubstr(secret)));
}

TEST_F(OpenAiClientTest, SpeaksTls) {
  const auto certificate = flair::testing::MakeTestCertificate();
  server_ = std::make_unique<flair::testing::ScriptedServer>(LoadScript("odd_pieces"), certificate);
  options_.config.set_base_url(server_->base_url());
  options_.config.set_stream(true);
  EXPECT_EQ(Ask().status().code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(server_->requests(), SizeIs(0));

  client_.reset();
  http_.ca_path = ::testing::TempDir() + "flair_openai_ca_" + std::to_string(getpid()) + ".pem";
  std::ofstream(http_.ca_path) << certificate.certificate_pem;
  const auto answer = Ask();
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_EQ(answer->text, kBedroom);
  unlink(http_.ca_path.c_str());
}

}  // namespace
}  // namespace flair::llm
