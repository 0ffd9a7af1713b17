// SPDX-License-Identifier: GPL-3.0-or-later
// What a server or a model may do wrong, one test each; the scripts are in tests/fixtures/llm_server/scripts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <thread>

#include "llm/testing/test_openai_client.h"

namespace flair::llm {
namespace {

using absl::StatusCode;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// Every fault both ways, streamed and not.
class OpenAiFaultsTest : public OpenAiClientTest, public ::testing::WithParamInterface<bool> {
 protected:
  OpenAiFaultsTest() { options_.config.set_stream(GetParam()); }

  // The error of a server that plays this script.
  absl::Status Fault(const std::string& script) {
    Serve(script);
    return Ask().status();
  }
};

INSTANTIATE_TEST_SUITE_P(, OpenAiFaultsTest, ::testing::Bool(),
                         [](const auto& info) { return info.param ? "Streamed" : "AtOnce"; });

TEST_P(OpenAiFaultsTest, PiecesThatEndInTheMiddleOfCharactersMakeTheSameAnswer) {
  for (const char* script : {"answer", "odd_pieces", "one_byte_pieces", "gzip"}) {
    Serve(script);
    const auto answer = Ask();
    ASSERT_TRUE(answer.ok()) << script << ": " << answer.status();
    EXPECT_EQ(answer->text, kBedroom) << script;
    EXPECT_EQ(answer->finish, FinishReason::kStop);
    EXPECT_FALSE(answer->usage.estimated);
  }
}

TEST_P(OpenAiFaultsTest, TooManyRequestsSaysWhenToComeBack) {
  const absl::Status status = Fault("rate_limited");
  EXPECT_EQ(status.code(), StatusCode::kUnavailable) << status;
  EXPECT_EQ(RetryAfter(status), absl::Seconds(7));
  EXPECT_THAT(status.message(), AllOf(HasSubstr("HTTP 429"), HasSubstr("rate_limit_exceeded")));
}

TEST_P(OpenAiFaultsTest, AnErrorOfTheServerIsOver) {
  const absl::Status status = Fault("error_then_answer");
  EXPECT_EQ(status.code(), StatusCode::kUnavailable) << status;
  EXPECT_EQ(RetryAfter(status), std::nullopt);
  const auto answer = Ask();
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_EQ(answer->text, kBedroom);
}

TEST_P(OpenAiFaultsTest, AResetInTheBodyCanBeTriedAgain) {
  EXPECT_EQ(Fault("reset_then_answer").code(), StatusCode::kUnavailable);
  EXPECT_TRUE(Ask().ok());
}

TEST_P(OpenAiFaultsTest, ASilentServerIsGivenUp) {
  http_.timeouts.first_byte = absl::Milliseconds(20);
  EXPECT_EQ(Fault("silent").code(), StatusCode::kUnavailable);
  server_->WaitForClosedByClient(1);
}

TEST_P(OpenAiFaultsTest, AServerThatFallsSilentIsGivenUp) {
  http_.timeouts.first_byte = absl::Milliseconds(40);
  EXPECT_EQ(Fault("silent_in_stream").code(), StatusCode::kUnavailable);
  server_->WaitForClosedByClient(1);
}

TEST_P(OpenAiFaultsTest, AServerThatDripsIsGivenUp) {
  http_.timeouts.total = absl::Milliseconds(60);
  EXPECT_EQ(Fault("slow_loris").code(), StatusCode::kUnavailable);
  server_->WaitForClosedByClient(1);
}

TEST_P(OpenAiFaultsTest, ABodyOfAGigabyteIsLeftWhereItIs) {
  const absl::Status status = Fault("gigabyte");
  EXPECT_EQ(status.code(), StatusCode::kDataLoss) << status;
  server_->WaitForClosedByClient(1);
}

TEST_P(OpenAiFaultsTest, CancellingClosesTheConnection) {
  Serve("silent_in_stream");
  client();
  absl::Status status;
  std::thread asker([&] { status = Ask().status(); });
  server_->WaitForRequests(1);
  call_.cancellation().Cancel();
  asker.join();
  EXPECT_EQ(status.code(), StatusCode::kCancelled);
  server_->WaitForClosedByClient(1);
}

TEST_P(OpenAiFaultsTest, ProseAroundTheJsonIsGivenAsItIs) {
  Serve("schema_ignored");
  const auto answer = Ask();
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_THAT(answer->text, AllOf(HasSubstr("Sure!"), HasSubstr(kBedroom), HasSubstr("Enjoy!")));
}

TEST_P(OpenAiFaultsTest, AToolCallIsTheAnswer) {
  Serve("tool_call");
  const auto answer = Ask();
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_EQ(answer->text, kBedroom);
  EXPECT_EQ(answer->finish, FinishReason::kStop);
}

TEST_P(OpenAiFaultsTest, AToolCallMayBeAnObject) {
  Serve("tool_call_as_object");
  const auto answer = Ask();
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_EQ(answer->text, R"({"zones":[]})");
}

TEST_P(OpenAiFaultsTest, TheContentMayComeInParts) {
  Serve("content_parts");
  const auto answer = Ask();
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_EQ(answer->text, R"({"a":1})");
}

TEST_P(OpenAiFaultsTest, AnAnswerThatWasCutOffSaysSo) {
  Serve("length");
  const auto answer = Ask();
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_EQ(answer->finish, FinishReason::kLength);
  EXPECT_EQ(answer->text, std::string(kBedroom).substr(0, 30));
}

TEST_P(OpenAiFaultsTest, AnAnswerThatTheFilterCutOffIsARefusal) {
  Serve("content_filter");
  const auto answer = Ask();
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_EQ(answer->finish, FinishReason::kRefused);
}

TEST_P(OpenAiFaultsTest, ARefusalIsAnAnswer) {
  Serve("refusal");
  const auto answer = Ask();
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_EQ(answer->finish, FinishReason::kRefused);
  EXPECT_EQ(answer->text, "I'm sorry, I can't help with that.");
}

TEST_P(OpenAiFaultsTest, AQuestionThatTheFilterStoppedIsRefused) {
  Serve("prompt_filtered");
  const auto answer = Ask();
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_EQ(answer->finish, FinishReason::kRefused);
  EXPECT_EQ(server_->requests().size(), 1u);
}

TEST_P(OpenAiFaultsTest, AWebPageIsNoAnswer) {
  const absl::Status status = Fault("html");
  EXPECT_EQ(status.code(), StatusCode::kDataLoss) << status;
  EXPECT_THAT(status.message(), HasSubstr("HTML"));
}

TEST_P(OpenAiFaultsTest, AnErrorPageIsAnErrorOfItsStatus) {
  const absl::Status status = Fault("html_error");
  EXPECT_EQ(status.code(), StatusCode::kUnavailable) << status;
  EXPECT_THAT(status.message(), AllOf(HasSubstr("HTTP 502"), Not(HasSubstr("<"))));
}

TEST_P(OpenAiFaultsTest, AnEmptyBodyIsNoAnswer) {
  const absl::Status status = Fault("empty");
  EXPECT_EQ(status.code(), StatusCode::kDataLoss) << status;
  EXPECT_THAT(status.message(), HasSubstr("empty"));
}

TEST_P(OpenAiFaultsTest, AnEmptyTextIsAnAnswer) {
  Serve("empty_answer");
  const auto answer = Ask();
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_EQ(answer->text, "");
}

TEST_P(OpenAiFaultsTest, AReplyWithoutChoicesIsNoAnswer) {
  EXPECT_EQ(Fault("no_choices").code(), StatusCode::kDataLoss);
}

TEST_P(OpenAiFaultsTest, BrokenJsonIsNoAnswer) { EXPECT_EQ(Fault("broken_json").code(), StatusCode::kDataLoss); }

TEST_P(OpenAiFaultsTest, HalfACharacterIsNoAnswer) { EXPECT_EQ(Fault("bad_utf8").code(), StatusCode::kDataLoss); }

TEST_P(OpenAiFaultsTest, FieldsOfWrongTypesCountAsMissing) {
  Serve("wrong_types");
  const auto answer = Ask();
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_EQ(answer->text, "");
  EXPECT_EQ(answer->model, "some-model");
  EXPECT_TRUE(answer->usage.estimated);
}

TEST_P(OpenAiFaultsTest, UsageThatTheServerDoesNotTellIsEstimated) {
  Serve("no_usage");
  const auto answer = Ask();
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_TRUE(answer->usage.estimated);
  EXPECT_EQ(answer->usage.output_token_count, EstimateTokens(kBedroom));
  EXPECT_GT(answer->usage.input_token_count, EstimateTokens(ZonesRequest().messages[0].text));
}

TEST_P(OpenAiFaultsTest, AnErrorInsideAReplyHasItsOwnStatus) {
  const absl::Status status = Fault("error_in_reply");
  EXPECT_EQ(status.code(), StatusCode::kUnavailable) << status;
  EXPECT_THAT(status.message(), HasSubstr("Provider returned error"));
}

// A script of one reply of status 200.
flair::testing::Script Replying(const std::string& json) {
  return flair::testing::ReadScript(R"({"repeat_last": true, "exchanges": [{"json": )" + json + "}]}");
}

TEST_P(OpenAiFaultsTest, AnErrorInsideAReplyThatWouldComeAgainIsNotTriedAgain) {
  Serve(Replying(R"({"error": {"message": "You exceeded your quota", "code": "insufficient_quota"}})"));
  EXPECT_EQ(Ask().status().code(), StatusCode::kFailedPrecondition);
  Serve(
      Replying(R"({"error": {"message": "No such key", "type": "invalid_request_error", "code": "invalid_api_key"}})"));
  EXPECT_EQ(Ask().status().code(), StatusCode::kUnauthenticated);
}

TEST_P(OpenAiFaultsTest, AnErrorThatSaysNothingBesideAnAnswerIsNone) {
  for (const char* error : {R"({"code": 0, "message": "", "type": null})", R"("")", "false", "{}", "[]"}) {
    Serve(Replying(std::string(R"({"error": )") + error +
                   R"(, "choices": [{"index": 0, "message": {"content": "hi"}, "finish_reason": "stop"}]})"));
    const auto answer = Ask();
    ASSERT_TRUE(answer.ok()) << error << ": " << answer.status();
    EXPECT_EQ(answer->text, "hi");
  }
}

TEST_P(OpenAiFaultsTest, AnAccountThatIsSpentIsNotTriedAgain) {
  EXPECT_EQ(Fault("quota_spent").code(), StatusCode::kFailedPrecondition);
}

TEST_P(OpenAiFaultsTest, AQuestionThatIsTooLongIsAskedOnceMoreWithoutALimitOfItsAnswer) {
  const absl::Status status = Fault("context_too_long");
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument) << status;
  EXPECT_THAT(status.message(), HasSubstr("maximum context length is 8192 tokens"));
  ASSERT_EQ(server_->requests().size(), 2u);
  EXPECT_FALSE(Sent(1).contains("max_tokens"));
  EXPECT_EQ(Sent(1)["response_format"]["type"], "json_schema");
}

TEST_P(OpenAiFaultsTest, AnUnknownModelIsNotFound) { EXPECT_EQ(Fault("unknown_model").code(), StatusCode::kNotFound); }

TEST_P(OpenAiFaultsTest, AnotherAddressIsNotFollowed) {
  const absl::Status status = Fault("moved");
  EXPECT_EQ(status.code(), StatusCode::kNotFound) << status;
  EXPECT_THAT(status.message(), HasSubstr("HTTP 308"));
}

TEST_P(OpenAiFaultsTest, AWrongKeyIsNotShownInTheError) {
  const absl::Status status = Fault("wrong_key");
  EXPECT_EQ(status.code(), StatusCode::kUnauthenticated) << status;
  EXPECT_THAT(status.ToString(), Not(HasSubstr("0123456789")));
  EXPECT_EQ(server_->requests().front().header("authorization"), "Bearer sk-0123456789abcdef");
}

// A stream has no length.
class OpenAiLengthFaultsTest : public OpenAiFaultsTest {};
INSTANTIATE_TEST_SUITE_P(, OpenAiLengthFaultsTest, ::testing::Values(false), [](const auto&) { return "AtOnce"; });

TEST_P(OpenAiLengthFaultsTest, AContentLengthBeyondTheBodyIsABrokenConnection) {
  EXPECT_EQ(Fault("content_length_too_long").code(), StatusCode::kUnavailable);
}

TEST_P(OpenAiLengthFaultsTest, AContentLengthWithinTheBodyIsNoAnswer) {
  EXPECT_EQ(Fault("content_length_too_short").code(), StatusCode::kDataLoss);
}

class OpenAiStreamFaultsTest : public OpenAiFaultsTest {};
INSTANTIATE_TEST_SUITE_P(, OpenAiStreamFaultsTest, ::testing::Values(true), [](const auto&) { return "Streamed"; });

TEST_P(OpenAiStreamFaultsTest, AStreamThatEndsEarlyIsABrokenConnection) {
  const absl::Status status = Fault("stream_ends_early");
  EXPECT_EQ(status.code(), StatusCode::kUnavailable) << status;
  EXPECT_THAT(status.message(), HasSubstr("ended early"));
}

TEST_P(OpenAiStreamFaultsTest, AStreamMayEndWithoutSayingDone) {
  Serve("stream_without_done");
  const auto answer = Ask();
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_EQ(answer->text, "{}");
}

TEST_P(OpenAiStreamFaultsTest, CommentsAndOtherFieldsOfAStreamAreSkipped) {
  Serve("stream_with_comments");
  const auto answer = Ask();
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_EQ(answer->text, "{}");
}

TEST_P(OpenAiStreamFaultsTest, AStreamOfManyMoreBytesThanItsTextIsReadToItsEnd) {
  // What a model thinks for an hour, as it is wrapped: 20 MB of events.
  flair::testing::Exchange exchange;
  const std::string comment = ": " + std::string(100000, 'x') + "\n\n";
  for (int i = 0; i < 200; ++i) exchange.body += comment;
  exchange.body += R"(data: {"choices": [{"index": 0, "delta": {"content": "{}"}, "finish_reason": "stop"}]})"
                   "\n\n";
  Serve(flair::testing::Script{.exchanges = {exchange}});
  const auto answer = Ask();
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_EQ(answer->text, "{}");
}

TEST_P(OpenAiStreamFaultsTest, AStreamOfTooMuchTextIsLeftWhereItIs) {
  flair::testing::Exchange exchange;
  const std::string event =
      R"(data: {"choices": [{"index": 0, "delta": {"reasoning": ")" + std::string(1 << 20, 'x') + "\"}}]}\n\n";
  for (int i = 0; i < 66; ++i) exchange.body += event;
  exchange.end = flair::testing::ConnectionEnd::kHang;
  Serve(flair::testing::Script{.exchanges = {exchange}});
  EXPECT_EQ(Ask().status().code(), StatusCode::kDataLoss);
}

TEST_P(OpenAiStreamFaultsTest, AnErrorInTheStreamCanBeTriedAgain) {
  const absl::Status status = Fault("error_in_stream");
  EXPECT_EQ(status.code(), StatusCode::kUnavailable) << status;
  EXPECT_THAT(status.message(), HasSubstr("Internal error"));
}

TEST_P(OpenAiStreamFaultsTest, AServerThatDoesNotStreamIsReadAllTheSame) {
  Serve("not_streamed");
  const auto answer = Ask();
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_EQ(answer->text, "{}");
}

}  // namespace
}  // namespace flair::llm
