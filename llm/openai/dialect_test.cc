// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "llm/openai/openai_client.h"

namespace flair::llm {
namespace {

// Everything that can be dropped is sent.
OpenAiOptions AllOptions() {
  OpenAiOptions options;
  options.config.set_temperature(0.2);
  options.config.set_seed(7);
  options.config.set_stream(true);
  return options;
}

std::optional<Dialect> Weaker(const char* message, int http_status = 400, const Dialect& dialect = {}) {
  return WeakerDialect(dialect, AllOptions(), /*with_schema=*/true, http_status,
                       {.message = message, .type = "", .code = "", .param = ""});
}

TEST(WeakerDialect, UnderstandsWhatServersSay) {
  struct Case {
    const char* message;
    Dialect expected;
  };
  const Case cases[] = {
      {"Unsupported parameter: 'max_tokens' is not supported with this model. Use 'max_completion_tokens' instead.",
       {.completion_token_limit = true}},
      {"Unsupported value: 'temperature' does not support 0.2 with this model. Only the default (1) value is "
       "supported.",
       {.temperature = false}},
      {"max_tokens is too large: 20000. This model supports at most 16384 completion tokens", {.token_limit = false}},
      {"'max_tokens' or 'max_completion_tokens' is too large: 4096. This model's maximum context length is 4096 tokens "
       "and your request has 1532 input tokens",
       {.token_limit = false}},
      {"This model's maximum context length is 8192 tokens. However, you requested 9096 tokens (5000 in the messages, "
       "4096 in the completion).",
       {.token_limit = false}},
      {"`temperature` may only be set to 1 when thinking is enabled.", {.temperature = false}},
      {"Your organization must be verified to stream this model.", {.stream = false}},
      {"Conversation roles must alternate user/assistant/user/assistant/...", {.system_role = false}},
      {"Invalid schema for response_format 'zones': In context=(), 'minItems' is not permitted.",
       {.schema_limits = false}},
      {"Unrecognized request argument supplied: seed", {.seed = false}},
      {"extra_forbidden seed: Extra inputs are not permitted", {.seed = false}},
      {"Invalid JSON payload received. Unknown name \"seed\": Cannot find field.", {.seed = false}},
      {"Unrecognized request argument supplied: stream_options", {.stream_usage = false}},
      {"Unsupported value: 'messages[0].role' does not support 'system' with this model.", {.system_role = false}},
      {"Invalid parameter: 'response_format' of type 'json_schema' is not supported with this model.",
       {.form = config::v1::ANSWER_FORM_JSON_OBJECT}},
      {"Invalid schema for response_format 'zones': In context=(), 'required' is required",
       {.form = config::v1::ANSWER_FORM_JSON_OBJECT}},
      {"response_format.type : value is not one of the allowed values ['text','json_object']",
       {.form = config::v1::ANSWER_FORM_JSON_OBJECT}},
      {"", {.form = config::v1::ANSWER_FORM_JSON_OBJECT}},
  };
  for (const Case& row : cases) {
    const auto weaker = Weaker(row.message);
    ASSERT_TRUE(weaker.has_value()) << row.message;
    EXPECT_EQ(*weaker, row.expected) << row.message;
  }
}

TEST(WeakerDialect, IsNoneForFaultsOfTheQuestion) {
  for (const char* message :
       {"This model's maximum context length is 4096 tokens. Your messages have 5123 tokens.",
        "gpt-x is not a valid model ID", "API key not valid",
        "The response was filtered due to the prompt triggering Azure OpenAI's content management policy"}) {
    EXPECT_FALSE(Weaker(message).has_value()) << message;
  }
}

TEST(WeakerDialect, IsNoneForStatusesThatSayNothingOfTheRequest) {
  for (const int http_status : {401, 403, 404, 429, 500, 503}) EXPECT_FALSE(Weaker("bad", http_status).has_value());
  EXPECT_TRUE(Weaker("failed to parse grammar", 500).has_value());
}

TEST(WeakerDialect, BecomesWeakerOnlySoOften) {
  std::optional<Dialect> dialect = Dialect();
  int count = 0;
  const char* complaint =
      "unsupported, at most: max_tokens, temperature, seed, stream_options, role system, minItems, response_format";
  while ((dialect = Weaker(complaint, 400, *dialect)).has_value()) ++count;
  EXPECT_EQ(count, 9);
}

TEST(WeakerDialect, KeepsTheFormOfARequestWithoutSchema) {
  EXPECT_FALSE(WeakerDialect({}, AllOptions(), /*with_schema=*/false, 400, {}).has_value());
}

TEST(WeakerDialect, DropsNothingThatWasNotSent) {
  const OpenAiOptions plain;
  const ServerError error{
      .message = "temperature and stream_options are not supported", .type = "", .code = "", .param = ""};
  EXPECT_FALSE(WeakerDialect({}, plain, /*with_schema=*/false, 400, error).has_value());
}

using nlohmann::json;
using ::testing::HasSubstr;

json Encode(const ChatRequest& request, const Dialect& dialect, const OpenAiOptions& options = {}) {
  const auto body = EncodeRequest(options, dialect, request);
  EXPECT_TRUE(body.ok()) << body.status();
  return body.ok() ? json::parse(*body) : json();
}

TEST(EncodeRequest, IsTheSameTextEachTime) {
  const ChatRequest request{
      .step = "s", .messages = {{Role::kUser, "q"}}, .schema = R"({"b":1,"a":2})", .schema_name = "n"};
  EXPECT_EQ(*EncodeRequest({}, {}, request), *EncodeRequest({}, {}, request));
}

TEST(EncodeRequest, ABodyMayEndWithItsMessages) {
  Dialect bare;
  bare.seed = bare.token_limit = false;
  const ChatRequest request{.step = "s", .messages = {{Role::kSystem, "p"}, {Role::kUser, "q"}}};
  OpenAiOptions options;
  options.config.set_model("m\"");
  EXPECT_EQ(*EncodeRequest(options, bare, request),
            R"({"model":"m\"","messages":[{"role":"system","content":"p"},{"role":"user","content":"q"}]})");
}

TEST(EncodeRequest, PutsTheSchemaIntoTheSystemsMessageWhereTheServerTakesNone) {
  const ChatRequest request{.step = "s",
                            .messages = {{Role::kSystem, "You plan."}, {Role::kUser, "q"}, {Role::kAssistant, "a"}},
                            .schema = R"({"type":"object"})",
                            .schema_name = "n"};
  for (const config::v1::AnswerForm form : {config::v1::ANSWER_FORM_JSON_OBJECT, config::v1::ANSWER_FORM_TEXT}) {
    const json body = Encode(request, {.form = form});
    EXPECT_EQ(body["messages"].size(), 3u);
    EXPECT_EQ(body["messages"][0]["content"],
              "You plan.\n\nAnswer with one JSON object and nothing else. It must follow this JSON schema:\n"
              R"({"type":"object"})");
    EXPECT_EQ(body["messages"][2]["role"], "assistant");
    EXPECT_EQ(body.contains("response_format"), form == config::v1::ANSWER_FORM_JSON_OBJECT);
  }
}

TEST(EncodeRequest, MakesASystemsMessageForTheSchemaWhereThereIsNone) {
  const ChatRequest request{
      .step = "s", .messages = {{Role::kUser, "q"}}, .schema = R"({"type":"object"})", .schema_name = "n"};
  const json body = Encode(request, {.form = config::v1::ANSWER_FORM_TEXT});
  EXPECT_EQ(body["messages"][0]["role"], "system");
  EXPECT_EQ(body["messages"][1]["content"], "q");
}

TEST(EncodeRequest, SpeaksToServersWithoutASystemRole) {
  const ChatRequest request{
      .step = "s", .messages = {{Role::kSystem, "You plan."}, {Role::kUser, "q"}}, .schema = "", .schema_name = ""};
  const json body = Encode(request, {.system_role = false});
  EXPECT_EQ(body["messages"], json::array({{{"role", "user"}, {"content", "You plan.\n\nq"}}}));
}

TEST(EncodeRequest, ReplacesWhatIsNotUtf8) {
  const ChatRequest request{.step = "s",
                            .messages = {{Role::kUser,
                                          "a\xff"
                                          "b"}},
                            .schema = "",
                            .schema_name = ""};
  EXPECT_EQ(Encode(request, {})["messages"][0]["content"],
            "a\xef\xbf\xbd"
            "b");
}

TEST(EncodeRequest, ASchemaThatIsNoneIsOurFault) {
  const ChatRequest request{.step = "zones", .messages = {{Role::kUser, "q"}}, .schema = "[", .schema_name = "n"};
  const auto body = EncodeRequest({}, {}, request);
  EXPECT_EQ(body.status().code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(body.status().message(), HasSubstr("zones"));
}

}  // namespace
}  // namespace flair::llm
