// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "llm/client/llm_client.h"
#include "llm/openai/reply_reader.h"

namespace flair::llm {
namespace {

using absl::StatusCode;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(ReadServerError, KnowsTheFormsOfManyServers) {
  struct Case {
    const char* server;
    const char* body;
    ServerError expected;
  };
  const Case cases[] = {
      {"OpenAI",
       R"({"error":{"message":"m","type":"invalid_request_error","param":"seed","code":"unknown_parameter"}})",
       {"m", "invalid_request_error", "unknown_parameter", "seed"}},
      {"vLLM",
       R"({"object":"error","message":"m","type":"BadRequestError","param":null,"code":400})",
       {"m", "BadRequestError", "400", ""}},
      {"llama.cpp",
       R"({"error":{"code":400,"message":"m","type":"invalid_request_error"}})",
       {"m", "invalid_request_error", "400", ""}},
      {"Ollama", R"({"error":"m"})", {"m", "", "", ""}},
      {"FastAPI",
       R"({"detail":[{"loc":["body","seed"],"msg":"m","type":"extra_forbidden"}]})",
       {"m", "extra_forbidden", "", "seed"}},
      {"Mistral",
       R"({"object":"error","message":{"detail":[{"loc":["body","seed"],"msg":"m","type":"extra_forbidden"}]}})",
       {"m", "extra_forbidden", "", "seed"}},
      {"FastAPI, short", R"({"detail":"Not Found"})", {"Not Found", "", "", ""}},
      {"Google", R"([{"error":{"code":429,"message":"m","status":"RESOURCE_EXHAUSTED"}}])", {"m", "", "429", ""}},
      {"Azure's gateway", R"({"statusCode":401,"message":"m"})", {"m", "", "", ""}},
      {"Azure's filter",
       R"({"error":{"message":"m","innererror":{"code":"ResponsibleAIPolicyViolation"}}})",
       {"m", "", "ResponsibleAIPolicyViolation", ""}},
  };
  for (const Case& row : cases) {
    const ServerError error = ReadServerError(row.body);
    EXPECT_EQ(error.message, row.expected.message) << row.server;
    EXPECT_EQ(error.type, row.expected.type) << row.server;
    EXPECT_EQ(error.code, row.expected.code) << row.server;
    EXPECT_EQ(error.param, row.expected.param) << row.server;
  }
}

TEST(ReadServerError, MakesNothingOfAnythingElse) {
  const std::string deep(100000, '[');
  for (const std::string& body :
       {std::string(), std::string("<html>"), std::string("[]"), std::string("7"), deep,
        std::string(R"({"error":[1]})"), std::string(R"({"detail":[]})"), std::string(R"({"detail":[{"loc":7}]})")}) {
    EXPECT_EQ(ReadServerError(body).message, "") << body.substr(0, 20);
  }
}

TEST(HttpStatusOf, IsTheCodeOrThatOfTheKind) {
  EXPECT_EQ(HttpStatusOf({.message = "m", .type = "", .code = "429", .param = ""}), 429);
  EXPECT_EQ(HttpStatusOf({.message = "m", .type = "invalid_request_error", .code = "insufficient_quota", .param = ""}),
            429);
  EXPECT_EQ(HttpStatusOf({.message = "m", .type = "invalid_request_error", .code = "", .param = ""}), 400);
  EXPECT_EQ(HttpStatusOf({.message = "m", .type = "authentication_error", .code = "none", .param = ""}), 401);
  for (const char* code : {"", "200", "99999999999", "server_error"}) {
    EXPECT_EQ(HttpStatusOf({.message = "m", .type = "", .code = code, .param = ""}), 500) << code;
  }
}

TEST(StatusOf, MapsEveryHttpStatus) {
  const std::pair<int, StatusCode> cases[] = {
      {301, StatusCode::kNotFound},        {304, StatusCode::kNotFound},           {400, StatusCode::kInvalidArgument},
      {401, StatusCode::kUnauthenticated}, {402, StatusCode::kFailedPrecondition}, {403, StatusCode::kPermissionDenied},
      {404, StatusCode::kNotFound},        {405, StatusCode::kInvalidArgument},    {407, StatusCode::kPermissionDenied},
      {408, StatusCode::kUnavailable},     {409, StatusCode::kUnavailable},        {410, StatusCode::kNotFound},
      {413, StatusCode::kInvalidArgument}, {422, StatusCode::kInvalidArgument},    {425, StatusCode::kUnavailable},
      {429, StatusCode::kUnavailable},     {500, StatusCode::kUnavailable},        {501, StatusCode::kUnavailable},
      {503, StatusCode::kUnavailable},     {529, StatusCode::kUnavailable}};
  for (const auto& [http_status, code] : cases) {
    EXPECT_EQ(StatusOf(http_status, {}, "http://h: HTTP", {}).code(), code) << http_status;
  }
}

TEST(StatusOf, ShowsOnePrintableLineOfTheServersText) {
  const std::string message = "bad\nthing: " + std::string(500, 'a');
  const auto status = StatusOf(400, {message, "t", "c", "p"}, "http://h: HTTP 400", {});
  EXPECT_THAT(status.message(), HasSubstr("http://h: HTTP 400, t, code c, field p, bad thing: aaa"));
  EXPECT_LT(status.message().size(), 400u);
}

TEST(StatusOf, CutsBetweenCharacters) {
  std::string message = "x";
  for (int i = 0; i < 200; ++i) message += "ü";
  const auto status = StatusOf(400, {message, "", "", ""}, "", {});
  EXPECT_THAT(status.message(), HasSubstr("ü..."));
}

TEST(StatusOf, ShowsNothingThatQuotesASecretOrAPrompt) {
  const std::vector<Message> messages = {{Role::kUser, "a bedroom for a deep-sea diver, 4 by 3 metres"},
                                         {Role::kUser, "hi"}};
  const Confidential confidential{.secrets = {"sk-proj-abcdefgh", ""}, .messages = messages};
  for (const char* text :
       {"key sk-proj-abcdefgh", "key sk-pro***", "key ***abcdefgh", "'room for a deep-sea diver'", "hi"}) {
    const auto status = StatusOf(400, {text, "", "", ""}, "h", confidential);
    EXPECT_THAT(status.message(), Not(HasSubstr(text)));
    EXPECT_THAT(status.message(), HasSubstr("quotes the request"));
  }
  EXPECT_THAT(StatusOf(400, {"the diver is too deep", "", "", ""}, "h", confidential).message(), HasSubstr("too deep"));
  // What a server says about a key is never shown: parts of it may be crossed out in any way.
  EXPECT_THAT(StatusOf(401, {"key s*-p*oj", "auth", "", ""}, "h", confidential).message(), Not(HasSubstr("oj")));
}

TEST(StatusOf, ASpentAccountIsNotOverload) {
  EXPECT_EQ(StatusOf(429, {"m", "insufficient_quota", "", ""}, "", {}).code(), StatusCode::kFailedPrecondition);
}

std::optional<absl::Duration> RetryAfterOf(std::vector<HttpHeader> headers) {
  absl::Status status = absl::UnavailableError("");
  AddRetryAfter({.status = 429, .headers = std::move(headers), .body = ""}, status);
  return RetryAfter(status);
}

TEST(AddRetryAfter, ReadsSecondsMillisecondsAndDates) {
  EXPECT_EQ(RetryAfterOf({}), std::nullopt);
  EXPECT_EQ(RetryAfterOf({{"retry-after", "20"}}), absl::Seconds(20));
  EXPECT_EQ(RetryAfterOf({{"retry-after", "0.5"}}), absl::Milliseconds(500));
  EXPECT_EQ(RetryAfterOf({{"retry-after", "1"}, {"retry-after-ms", "250"}}), absl::Milliseconds(250));
  EXPECT_EQ(RetryAfterOf({{"date", "Sat, 21 Nov 2026 08:00:00 GMT"}, {"retry-after", "Sat, 21 Nov 2026 08:01:30 GMT"}}),
            absl::Seconds(90));
  EXPECT_EQ(RetryAfterOf({{"retry-after", "Sat, 21 Nov 2026 08:01:30 GMT"}}), std::nullopt);
  EXPECT_EQ(RetryAfterOf({{"retry-after", "soon"}}), std::nullopt);
  EXPECT_EQ(RetryAfterOf({{"retry-after", "-3"}}), absl::ZeroDuration());
  EXPECT_EQ(RetryAfterOf({{"retry-after", "nan"}}), std::nullopt);
  EXPECT_EQ(RetryAfterOf({{"retry-after", "1e300"}}), absl::Hours(24));
}

}  // namespace
}  // namespace flair::llm
