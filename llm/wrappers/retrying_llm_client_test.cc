// SPDX-License-Identifier: GPL-3.0-or-later
#include <thread>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "llm/http/http_client.h"
#include "llm/testing/test_llm_client.h"
#include "llm/wrappers/llm_wrappers.h"
#include "worker_runtime/testing/fakes.h"

namespace flair::llm {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class RetryingLlmClientTest : public ::testing::Test {
 protected:
  absl::StatusOr<ChatAnswer> Ask() { return client_.Ask(AskFor("zones"), call_); }
  static absl::Status Down() { return absl::UnavailableError("status 503"); }
  static ChatAnswer Fine() {
    ChatAnswer answer;
    answer.text = "fine";
    return answer;
  }

  runtime::FakeClock clock_;
  std::vector<absl::Duration> delays_;
  TestLlmClient* model_ = new TestLlmClient();
  RetryingLlmClient client_{std::unique_ptr<LlmClient>(model_),
                            {.attempt_limit = 3},
                            clock_,
                            [this](absl::Duration delay, runtime::CallContext&) {
                              delays_.push_back(delay);
                              clock_.Advance(delay);
                            }};
  runtime::CallContext call_{"job-1", absl::InfiniteFuture(), clock_};
};

TEST_F(RetryingLlmClientTest, AsksAgainAfterUnavailableAndGivesTheAnswer) {
  model_->answer = [](size_t number) { return number == 1 ? absl::StatusOr<ChatAnswer>(Down()) : Fine(); };
  EXPECT_EQ(Ask()->text, "fine");
  ASSERT_THAT(model_->requests, SizeIs(2));
  EXPECT_EQ(model_->requests[1].step, "zones");
  ASSERT_THAT(delays_, SizeIs(1));
  EXPECT_LE(delays_[0], absl::Seconds(1));
}

TEST_F(RetryingLlmClientTest, GivesUpAfterTheLastAttemptAndSaysHowManyThereWere) {
  model_->answer = [](size_t) { return Down(); };
  const absl::Status status = Ask().status();
  EXPECT_TRUE(absl::IsUnavailable(status));
  EXPECT_THAT(std::string(status.message()), HasSubstr("status 503 (after 3 attempts)"));
  EXPECT_THAT(model_->requests, SizeIs(3));
}

TEST_F(RetryingLlmClientTest, NeverAsksAgainAfterWhatWouldFailAgain) {
  for (const absl::Status& failure :
       {absl::InvalidArgumentError("400"), absl::UnauthenticatedError("401"), absl::PermissionDeniedError("403"),
        absl::NotFoundError("404"), absl::DataLossError("html"), absl::CancelledError("")}) {
    model_->answer = [&](size_t) { return failure; };
    EXPECT_EQ(Ask().status(), failure);
  }
  EXPECT_THAT(delays_, IsEmpty());
}

TEST_F(RetryingLlmClientTest, WaitsAtLeastAsLongAsTheServerAsks) {
  absl::Status busy = Down();
  SetRetryAfter(busy, absl::Seconds(20));
  model_->answer = [&](size_t number) { return number == 1 ? absl::StatusOr<ChatAnswer>(busy) : Fine(); };
  ASSERT_TRUE(Ask().ok());
  ASSERT_THAT(delays_, SizeIs(1));
  EXPECT_GE(delays_[0], absl::Seconds(20));
  EXPECT_LE(delays_[0], absl::Seconds(30));
}

TEST_F(RetryingLlmClientTest, EndsAtOnceWhenTheServerAsksForMoreThanTheLongestDelay) {
  absl::Status busy = Down();
  SetRetryAfter(busy, absl::Hours(1));
  model_->answer = [&](size_t) { return busy; };
  EXPECT_TRUE(absl::IsUnavailable(Ask().status()));
  EXPECT_THAT(delays_, IsEmpty());
}

TEST_F(RetryingLlmClientTest, DoesNotBeginAWaitThatOutlastsTheDeadline) {
  runtime::CallContext call("job-2", clock_.Now() + absl::Milliseconds(300), clock_);
  model_->answer = [](size_t) { return Down(); };
  EXPECT_TRUE(absl::IsUnavailable(client_.Ask(AskFor("zones"), call).status()));
  EXPECT_THAT(delays_, IsEmpty());
}

TEST_F(RetryingLlmClientTest, AServerThatHangsHasHalfTheCallersTime) {
  runtime::CallContext call("job-2", clock_.Now() + absl::Minutes(10), clock_);
  model_->answer = [this](size_t) {
    clock_.Advance(absl::Minutes(2));
    return Down();
  };
  const absl::Time begin = clock_.Now();
  EXPECT_TRUE(absl::IsUnavailable(client_.Ask(AskFor("zones"), call).status()));
  EXPECT_LE(clock_.Now() - begin, absl::Minutes(5));
  EXPECT_THAT(model_->requests, SizeIs(2));
}

TEST_F(RetryingLlmClientTest, FurtherAttemptsEndWithinHalfTheCallersTime) {
  runtime::CallContext call("job-2", clock_.Now() + absl::Minutes(10), clock_);
  const absl::Time half = clock_.Now() + absl::Minutes(5);
  model_->answer = [this](size_t) {
    clock_.Advance(absl::Seconds(100));
    return Down();
  };
  EXPECT_TRUE(absl::IsUnavailable(client_.Ask(AskFor("zones"), call).status()));
  EXPECT_THAT(model_->deadlines, ::testing::ElementsAre(call.deadline(), half));
  EXPECT_LE(HttpTimeouts().total, absl::Seconds(285)) << "what the first attempt takes";
}

TEST_F(RetryingLlmClientTest, ACancelledCallDoesNotWaitForItsNextAttempt) {
  auto* model = new TestLlmClient();
  RetryingLlmClient client(std::unique_ptr<LlmClient>(model), {.first_delay = absl::Hours(1)}, clock_);
  std::thread canceller;
  model->answer = [&](size_t) {
    canceller = std::thread([&] { call_.cancellation().Cancel(); });
    return Down();
  };
  EXPECT_TRUE(absl::IsCancelled(client.Ask(AskFor("zones"), call_).status()));
  EXPECT_THAT(model->requests, SizeIs(1));
  canceller.join();
}

TEST(RetryPolicy, DelaysDoubleAreSpreadByTheKeyAndStayBelowTheLongest) {
  const RetryPolicy policy{.attempt_limit = 20, .first_delay = absl::Seconds(1), .longest_delay = absl::Seconds(10)};
  const absl::Status down = absl::UnavailableError("");
  for (int attempt = 1; attempt < 20; ++attempt) {
    const absl::Duration delay = *policy.DelayAfter(down, attempt, "a");
    const absl::Duration own = std::min(absl::Seconds(1) * (1 << (attempt - 1)), absl::Seconds(10));
    EXPECT_GE(delay, own);
    EXPECT_LE(delay, own * 1.5);
  }
  EXPECT_EQ(policy.DelayAfter(down, 20, "a"), std::nullopt);
  EXPECT_NE(policy.DelayAfter(down, 1, "a"), policy.DelayAfter(down, 1, "b"));
}

}  // namespace
}  // namespace flair::llm
