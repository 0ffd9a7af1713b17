// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/wrappers/limiting_llm_client.h"

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "llm/wrappers/held_llm_client.h"
#include "worker_runtime/testing/fakes.h"

namespace flair::llm {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class LimitingLlmClientTest : public ::testing::Test {
 protected:
  void Limit(CallLimits limits) {
    held_ = new HeldLlmClient();
    client_ = std::make_unique<LimitingLlmClient>(std::unique_ptr<LlmClient>(held_), limits, timer_, clock_);
  }
  void Ask(const std::string& step, runtime::CallContext& call) {
    client_->Ask(AskFor(step), call, [this, step](const absl::StatusOr<ChatAnswer>& answer) {
      ended_.push_back(step);
      statuses_.push_back(answer.status());
    });
  }
  std::vector<std::string> Begun() const {
    std::vector<std::string> steps;
    for (const ChatRequest& request : held_->requests) steps.push_back(request.step);
    return steps;
  }
  static ChatAnswer Consuming(int64_t tokens) {
    ChatAnswer answer;
    answer.usage.input_token_count = tokens;
    return answer;
  }

  runtime::FakeClock clock_;
  runtime::FakeTimer timer_{clock_};
  HeldLlmClient* held_ = nullptr;
  std::unique_ptr<LimitingLlmClient> client_;
  std::vector<std::string> ended_;
  std::vector<absl::Status> statuses_;
  runtime::CallContext call_{"", absl::InfiniteFuture(), clock_};
};

TEST_F(LimitingLlmClientTest, LetsSoManyCallsThroughAndTheOthersInTheirOrder) {
  Limit({.in_flight = 2});
  for (const char* step : {"a", "b", "c", "d"}) Ask(step, call_);
  timer_.Advance(absl::ZeroDuration());
  EXPECT_THAT(Begun(), ElementsAre("a", "b"));
  held_->Answer(1, "");
  timer_.Advance(absl::ZeroDuration());
  EXPECT_THAT(Begun(), ElementsAre("a", "b", "c"));
  held_->Answer(0, absl::UnavailableError(""));
  timer_.Advance(absl::ZeroDuration());
  EXPECT_THAT(Begun(), ElementsAre("a", "b", "c", "d"));
  EXPECT_THAT(ended_, ElementsAre("b", "a"));
}

TEST_F(LimitingLlmClientTest, ACallThatIsCancelledLeavesTheQueueAndIsNeverMade) {
  Limit({.in_flight = 1});
  runtime::CallContext other("", absl::InfiniteFuture(), clock_);
  Ask("a", call_);
  Ask("b", other);
  Ask("c", call_);
  other.cancellation().Cancel();
  timer_.Advance(absl::ZeroDuration());
  ASSERT_THAT(ended_, ElementsAre("b"));
  EXPECT_TRUE(absl::IsCancelled(statuses_[0]));
  held_->Answer(0, "");
  timer_.Advance(absl::ZeroDuration());
  EXPECT_THAT(Begun(), ElementsAre("a", "c"));
}

TEST_F(LimitingLlmClientTest, ACallWhoseDeadlineComesInTheQueueEndsThen) {
  Limit({.in_flight = 1});
  runtime::CallContext hasty("", clock_.Now() + absl::Seconds(3), clock_);
  Ask("a", call_);
  Ask("b", hasty);
  timer_.Advance(absl::Seconds(2));
  EXPECT_THAT(ended_, IsEmpty());
  timer_.Advance(absl::Seconds(2));
  ASSERT_THAT(ended_, ElementsAre("b"));
  EXPECT_TRUE(absl::IsDeadlineExceeded(statuses_[0]));
}

TEST_F(LimitingLlmClientTest, ACallThatWasCancelledBeforeItCameLeavesToo) {
  Limit({.in_flight = 1});
  runtime::CallContext gone("", absl::InfiniteFuture(), clock_);
  gone.cancellation().Cancel();
  Ask("a", call_);
  Ask("b", gone);
  timer_.Advance(absl::ZeroDuration());
  EXPECT_THAT(ended_, ElementsAre("b"));
}

TEST_F(LimitingLlmClientTest, TokensThatAreSpentComeBackEvenly) {
  Limit({.in_flight = 100, .tokens_per_minute = 600});
  Ask("a", call_);
  held_->Answer(0, Consuming(700));
  // 100 below empty, 10 a second.
  Ask("b", call_);
  timer_.Advance(absl::Seconds(10));
  EXPECT_THAT(Begun(), ElementsAre("a"));
  timer_.Advance(absl::Seconds(0.2));
  EXPECT_THAT(Begun(), ElementsAre("a", "b"));
}

TEST_F(LimitingLlmClientTest, AMinuteWithoutCallsSavesNoMoreThanAMinutesTokens) {
  Limit({.in_flight = 100, .tokens_per_minute = 600});
  clock_.Advance(absl::Hours(5));
  Ask("a", call_);
  held_->Answer(0, Consuming(1200));
  Ask("b", call_);
  timer_.Advance(absl::Seconds(59));
  EXPECT_THAT(Begun(), ElementsAre("a"));
  timer_.Advance(absl::Seconds(2));
  EXPECT_THAT(Begun(), ElementsAre("a", "b"));
}

TEST_F(LimitingLlmClientTest, ManyThatWaitForTokensAreWokenUpForByOneTimer) {
  Limit({.in_flight = 1000, .tokens_per_minute = 600});
  Ask("first", call_);
  held_->Answer(0, Consuming(700));
  constexpr int kCallCount = 300;
  for (int i = 0; i < kCallCount; ++i) Ask(std::to_string(i), call_);
  // A question takes a token of the 10 a second; each may begin when there is one.
  for (int i = 0; i < 600 && static_cast<int>(Begun().size()) <= kCallCount; ++i) timer_.Advance(absl::Seconds(0.2));
  EXPECT_THAT(Begun(), SizeIs(kCallCount + 1));
  // One each to its deadline, and some for tokens.
  EXPECT_LE(timer_.delays().size(), 3u * kCallCount);
}

TEST_F(LimitingLlmClientTest, QuestionsInFlightCountBeforeTheirAnswers) {
  Limit({.in_flight = 100, .tokens_per_minute = 4});
  Ask("a long question", call_);
  Ask("b", call_);
  EXPECT_THAT(held_->requests, SizeIs(1));
  call_.cancellation().Cancel();
  timer_.Advance(absl::ZeroDuration());
}

}  // namespace
}  // namespace flair::llm
