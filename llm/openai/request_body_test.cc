// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/openai/request_body.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

namespace flair::llm {
namespace {

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
  options.model = "m\"";
  EXPECT_EQ(*EncodeRequest(options, bare, request),
            R"({"model":"m\"","messages":[{"role":"system","content":"p"},{"role":"user","content":"q"}]})");
}

TEST(EncodeRequest, PutsTheSchemaIntoTheSystemsMessageWhereTheServerTakesNone) {
  const ChatRequest request{.step = "s",
                            .messages = {{Role::kSystem, "You plan."}, {Role::kUser, "q"}, {Role::kAssistant, "a"}},
                            .schema = R"({"type":"object"})",
                            .schema_name = "n"};
  for (const AnswerForm form : {AnswerForm::kJsonObject, AnswerForm::kText}) {
    const json body = Encode(request, {.form = form});
    EXPECT_EQ(body["messages"].size(), 3u);
    EXPECT_EQ(body["messages"][0]["content"],
              "You plan.\n\nAnswer with one JSON object and nothing else. It must follow this JSON schema:\n"
              R"({"type":"object"})");
    EXPECT_EQ(body["messages"][2]["role"], "assistant");
    EXPECT_EQ(body.contains("response_format"), form == AnswerForm::kJsonObject);
  }
}

TEST(EncodeRequest, MakesASystemsMessageForTheSchemaWhereThereIsNone) {
  const ChatRequest request{
      .step = "s", .messages = {{Role::kUser, "q"}}, .schema = R"({"type":"object"})", .schema_name = "n"};
  const json body = Encode(request, {.form = AnswerForm::kText});
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
