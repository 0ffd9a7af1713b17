// SPDX-License-Identifier: GPL-3.0-or-later
// How the client learns what a server takes, and what its model is like.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

class OpenAiLearningTest : public OpenAiClientTest {};

TEST_F(OpenAiLearningTest, RemembersThatAServerKnowsNoSchema) {
  Serve("json_mode_only");
  ASSERT_TRUE(Ask().ok());
  ASSERT_TRUE(Ask().ok());
  ASSERT_THAT(server_->requests(), SizeIs(3));
  EXPECT_EQ(Sent(0)["response_format"]["type"], "json_schema");
  EXPECT_EQ(Sent(1)["response_format"], (json{{"type", "json_object"}}));
  EXPECT_EQ(Sent(2), Sent(1));
  // The schema is in the prompt instead.
  EXPECT_THAT(Sent(1)["messages"][0]["content"].get<std::string>(), HasSubstr(ZonesRequest().schema));
}

TEST_F(OpenAiLearningTest, FallsBackToTextEvenWhenTheServerDoesNotSayWhy) {
  Serve("text_only");
  ASSERT_TRUE(Ask().ok());
  ASSERT_TRUE(Ask().ok());
  ASSERT_THAT(server_->requests(), SizeIs(4));
  EXPECT_FALSE(Sent(2).contains("response_format"));
  EXPECT_EQ(Sent(3), Sent(2));
}

TEST_F(OpenAiLearningTest, DoesNotFallBackWhenToldNotTo) {
  options_.config.set_answer_form(config::v1::ANSWER_FORM_JSON_SCHEMA);
  Serve("json_mode_only");
  const auto answer = Ask();
  EXPECT_EQ(answer.status().code(), StatusCode::kInvalidArgument) << answer.status();
  EXPECT_THAT(answer.status().message(), HasSubstr("'json_schema' is not supported"));
  EXPECT_THAT(server_->requests(), SizeIs(1));
}

TEST_F(OpenAiLearningTest, ARejectedSchemaLeavesOtherSchemasAlone) {
  auto script = LoadScript("answer");
  auto& rejection = *script.exchanges.insert(script.exchanges.begin(), flair::testing::Exchange());
  rejection.status = 400;
  rejection.body = R"({"error":{"message":"Invalid schema for response_format 'zones'","param":"response_format"}})";
  Serve(script);
  ASSERT_TRUE(Ask().ok());
  ASSERT_TRUE(Ask().ok());
  ChatRequest other = ZonesRequest();
  other.schema_name = "objects";
  ASSERT_TRUE(Ask(other).ok());
  ASSERT_THAT(server_->requests(), SizeIs(4));
  EXPECT_EQ(Sent(1)["response_format"]["type"], "json_object");
  EXPECT_EQ(Sent(2)["response_format"]["type"], "json_object");
  EXPECT_EQ(Sent(3)["response_format"]["type"], "json_schema");
}

TEST_F(OpenAiLearningTest, SendsReasoningModelsWhatTheyTake) {
  options_.config.set_temperature(0.2);
  Serve("reasoning_model");
  ASSERT_TRUE(Ask().ok());
  ASSERT_TRUE(Ask().ok());
  ASSERT_THAT(server_->requests(), SizeIs(4));
  EXPECT_EQ(Sent(3)["max_completion_tokens"], 4096);
  EXPECT_FALSE(Sent(3).contains("max_tokens"));
  EXPECT_FALSE(Sent(3).contains("temperature"));
  EXPECT_EQ(Sent(3)["response_format"]["type"], "json_schema");
}

// One that enforces its schema, and the answer "{}" does not keep to it.
ChatRequest RequestWithRequired() {
  ChatRequest request = ZonesRequest();
  request.schema = R"({"type":"object","properties":{"zones":{"type":"array","maxItems":3}},"required":["zones"]})";
  return request;
}

TEST_F(OpenAiLearningTest, TellsTheSchemaInThePromptWhereTheServerDoesNotKeepToIt) {
  Serve("schema_ignored");
  ASSERT_TRUE(Ask(RequestWithRequired()).ok());
  ASSERT_TRUE(Ask(RequestWithRequired()).ok());
  ASSERT_THAT(server_->requests(), SizeIs(2));
  EXPECT_THAT(Sent(0)["messages"][0]["content"].get<std::string>(), Not(HasSubstr("JSON schema")));
  EXPECT_THAT(Sent(1)["messages"][0]["content"].get<std::string>(), HasSubstr(RequestWithRequired().schema));
  EXPECT_EQ(Sent(1)["response_format"]["type"], "json_schema");
}

TEST_F(OpenAiLearningTest, AServerThatKeptToASchemaOnceIsTrusted) {
  auto script = LoadScript("schema_ignored");
  script.exchanges.insert(script.exchanges.begin(), LoadScript("answer").exchanges.front());
  Serve(script);
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(Ask(RequestWithRequired()).ok());
  EXPECT_EQ(Sent(2), Sent(0));
}

TEST_F(OpenAiLearningTest, KeepsTheSchemaButForLimitsThatTheServerDoesNotKnow) {
  auto script = LoadScript("answer");
  auto& rejection = *script.exchanges.insert(script.exchanges.begin(), flair::testing::Exchange());
  rejection.status = 400;
  rejection.body =
      R"({"error":{"message":"Invalid schema for response_format 'zones': 'maxItems' is not permitted."}})";
  Serve(script);
  ASSERT_TRUE(Ask(RequestWithRequired()).ok());
  EXPECT_EQ(Sent(1)["response_format"]["json_schema"]["schema"]["properties"]["zones"], (json{{"type", "array"}}));
}

TEST_F(OpenAiLearningTest, AModelThatThinksGetsRoomForIt) {
  const json without_text = {{"choices", {{{"finish_reason", "length"}}}}};
  const json summed_up = {{"choices", {{{"message", {{"content", "{}"}}}, {"finish_reason", "stop"}}}},
                          {"usage", {{"prompt_tokens", 10}, {"completion_tokens", 5}, {"total_tokens", 800}}}};
  for (const json& reply : {json(), without_text, summed_up}) {
    auto script = LoadScript("answer");
    if (reply.is_null()) {
      script.exchanges.front().answer["reasoning_tokens"] = 800;
    } else {
      script.exchanges.front().answer = nullptr;
      script.exchanges.front().body = reply.dump();
    }
    Serve(script);
    ASSERT_TRUE(Ask().ok()) << reply;
    ASSERT_TRUE(Ask().ok()) << reply;
    EXPECT_EQ(Sent(0)["max_tokens"], 4096) << reply;
    EXPECT_EQ(Sent(1)["max_tokens"], 16384) << reply;
  }
}

TEST_F(OpenAiLearningTest, LeavesOutWhatAStrictServerDoesNotKnow) {
  options_.config.set_seed(7);
  options_.config.set_stream(true);
  Serve("strict_fields");
  const auto answer = Ask();
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_TRUE(answer->usage.estimated);
  EXPECT_FALSE(Sent(2).contains("seed"));
  EXPECT_FALSE(Sent(2).contains("stream_options"));
  EXPECT_EQ(Sent(2)["response_format"]["type"], "json_schema");
}

TEST_F(OpenAiLearningTest, GivesUpWhenNoFormHelps) {
  auto script = LoadScript("answer");
  script.exchanges.front() = {};
  script.exchanges.front().status = 400;
  script.exchanges.front().body = "no";
  Serve(script);
  EXPECT_EQ(Ask().status().code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(server_->requests(), SizeIs(3));
  // Nothing was learnt from it.
  EXPECT_FALSE(Ask().ok());
  EXPECT_EQ(Sent(3)["response_format"]["type"], "json_schema");
}

TEST_F(OpenAiLearningTest, AskedByManyAtOnceItLearnsOnce) {
  Serve("json_mode_only");
  constexpr int kCount = 40;
  const std::vector<ChatRequest> requests(kCount, ZonesRequest());
  for (const auto& answer : AskAll(client(), requests, call_)) ASSERT_TRUE(answer.ok()) << answer.status();
  const size_t before = server_->requests().size();
  EXPECT_LE(before, 2u * kCount);
  ASSERT_TRUE(Ask().ok());
  EXPECT_EQ(server_->requests().size(), before + 1);
}

}  // namespace
}  // namespace flair::llm
