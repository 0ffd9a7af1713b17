// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/wrappers/retrying_llm_client.h"

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "llm/client/retry_hint.h"
#include "llm/wrappers/held_llm_client.h"
#include "worker_runtime/testing/fakes.h"

namespace flair::llm {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

class RetryingLlmClientTest : public ::testing::Test {
 protected:
  void Ask(runtime::CallContext& call) {
    client_.Ask(AskFor("zones"), call, [this](absl::StatusOr<ChatAnswer> answer) { answers_.push_back(answer); });
  }
  absl::Status Down() { return absl::UnavailableError("status 503"); }

  runtime::FakeClock clock_;
  runtime::FakeTimer timer_{clock_};
  HeldLlmClient* held_ = new HeldLlmClient();
  RetryingLlmClient client_{std::unique_ptr<LlmClient>(held_), {.attempt_limit = 3}, timer_, clock_};
  std::vector<absl::StatusOr<ChatAnswer>> answers_;
  runtime::CallContext call_{"job-1", absl::InfiniteFuture(), clock_};
};

TEST_F(RetryingLlmClientTest, AsksAgainAfterUnavailableAndGivesTheAnswer) {
  Ask(call_);
  held_->Answer(0, Down());
  EXPECT_THAT(answers_, SizeIs(0));
  timer_.Advance(absl::Seconds(1));
  ASSERT_THAT(held_->requests, SizeIs(2));
  EXPECT_EQ(held_->requests[1].step, "zones");
  held_->Answer(1, "fine");
  ASSERT_THAT(answers_, SizeIs(1));
  EXPECT_EQ(answers_[0]->text, "fine");
}

TEST_F(RetryingLlmClientTest, GivesUpAfterTheLastAttemptAndSaysHowManyThereWere) {
  Ask(call_);
  for (size_t i = 0; i < 3; ++i) {
    held_->Answer(i, Down());
    timer_.Advance(absl::Seconds(10));
  }
  ASSERT_THAT(answers_, SizeIs(1));
  EXPECT_TRUE(absl::IsUnavailable(answers_[0].status()));
  EXPECT_THAT(std::string(answers_[0].status().message()), HasSubstr("status 503 (after 3 attempts)"));
  EXPECT_THAT(held_->requests, SizeIs(3));
}

TEST_F(RetryingLlmClientTest, NeverAsksAgainAfterWhatWouldFailAgain) {
  for (const absl::Status& failure :
       {absl::InvalidArgumentError("400"), absl::UnauthenticatedError("401"), absl::PermissionDeniedError("403"),
        absl::NotFoundError("404"), absl::DataLossError("html"), absl::CancelledError("")}) {
    answers_.clear();
    Ask(call_);
    held_->Answer(held_->requests.size() - 1, failure);
    ASSERT_THAT(answers_, SizeIs(1)) << failure;
    EXPECT_EQ(answers_[0].status(), failure);
  }
  EXPECT_EQ(timer_.waiting(), 0);
}

TEST_F(RetryingLlmClientTest, WaitsAtLeastAsLongAsTheServerAsks) {
  Ask(call_);
  absl::Status busy = Down();
  SetRetryAfter(busy, absl::Seconds(20));
  held_->Answer(0, busy);
  timer_.Advance(absl::Seconds(19.9));
  EXPECT_THAT(held_->requests, SizeIs(1));
  timer_.Advance(absl::Seconds(10.2));
  EXPECT_THAT(held_->requests, SizeIs(2));
}

TEST_F(RetryingLlmClientTest, EndsAtOnceWhenTheServerAsksForMoreThanTheLongestDelay) {
  Ask(call_);
  absl::Status busy = Down();
  SetRetryAfter(busy, absl::Hours(1));
  held_->Answer(0, busy);
  ASSERT_THAT(answers_, SizeIs(1));
  EXPECT_TRUE(absl::IsUnavailable(answers_[0].status()));
}

TEST_F(RetryingLlmClientTest, DoesNotBeginAWaitThatOutlastsTheDeadline) {
  runtime::CallContext call("job-2", clock_.Now() + absl::Milliseconds(300), clock_);
  Ask(call);
  held_->Answer(0, Down());
  ASSERT_THAT(answers_, SizeIs(1));
  EXPECT_TRUE(absl::IsUnavailable(answers_[0].status()));
}

TEST_F(RetryingLlmClientTest, ACancelledCallDoesNotWaitForItsNextAttempt) {
  Ask(call_);
  held_->Answer(0, Down());
  call_.cancellation().Cancel();
  timer_.Advance(absl::ZeroDuration());
  ASSERT_THAT(answers_, SizeIs(1));
  EXPECT_TRUE(absl::IsCancelled(answers_[0].status()));
  EXPECT_THAT(held_->requests, SizeIs(1));
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
