// SPDX-License-Identifier: GPL-3.0-or-later
#include <condition_variable>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "llm/testing/test_llm_client.h"
#include "llm/wrappers/llm_wrappers.h"
#include "worker_runtime/testing/fakes.h"

namespace flair::llm {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

// Holds every call until the test answers it, by its step. Thread-safe.
class HeldLlmClient final : public LlmClient {
 public:
  absl::StatusOr<ChatAnswer> Ask(const ChatRequest& request, runtime::CallContext&) override {
    std::unique_lock lock(mutex_);
    begun_.push_back(request.step);
    changed_.notify_all();
    changed_.wait(lock, [&] { return answers_.contains(request.step); });
    return answers_.at(request.step);
  }
  std::string identity() const override { return "held@test"; }

  void Answer(const std::string& step, absl::StatusOr<ChatAnswer> answer) {
    const std::lock_guard lock(mutex_);
    answers_.emplace(step, std::move(answer));
    changed_.notify_all();
  }

  // Waits until so many calls have begun; their steps, in order.
  std::vector<std::string> Begun(size_t count) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return begun_.size() >= count; });
    return begun_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::string> begun_;
  std::map<std::string, absl::StatusOr<ChatAnswer>> answers_;
};

class LimitingLlmClientTest : public ::testing::Test {
 protected:
  ~LimitingLlmClientTest() override {
    for (auto& [step, thread] : threads_) thread.join();
  }

  void Limit(CallLimits limits) {
    held_ = new HeldLlmClient();
    client_ = std::make_unique<LimitingLlmClient>(std::unique_ptr<LlmClient>(held_), limits, clock_);
  }
  // Asks in a thread of its own.
  void Ask(const std::string& step, runtime::CallContext& call) {
    threads_.emplace(step, std::thread([&, step] {
                       const absl::Status status = client_->Ask(AskFor(step), call).status();
                       const std::lock_guard lock(mutex_);
                       statuses_[step] = status;
                     }));
  }
  // Asks, and waits until the call is in the queue behind so many others.
  void AskInVain(const std::string& step, runtime::CallContext& call, int others = 0) {
    Ask(step, call);
    while (client_->waiting() <= others) std::this_thread::yield();
  }
  absl::Status End(const std::string& step) {
    threads_.at(step).join();
    threads_.erase(step);
    return statuses_.at(step);
  }
  static ChatAnswer Consuming(int64_t tokens) {
    ChatAnswer answer;
    answer.usage.input_token_count = tokens;
    return answer;
  }

  runtime::FakeClock clock_;
  runtime::CallContext call_{"", absl::InfiniteFuture(), clock_};
  HeldLlmClient* held_ = nullptr;
  std::unique_ptr<LimitingLlmClient> client_;
  std::mutex mutex_;
  std::map<std::string, absl::Status> statuses_;
  std::map<std::string, std::thread> threads_;
};

TEST_F(LimitingLlmClientTest, LetsSoManyCallsThroughAndTheOthersInTheirOrder) {
  Limit({.in_flight = 2});
  Ask("a", call_);
  held_->Begun(1);
  Ask("b", call_);
  held_->Begun(2);
  AskInVain("c", call_);
  AskInVain("d", call_, 1);
  held_->Answer("b", ChatAnswer());
  EXPECT_THAT(held_->Begun(3), ElementsAre("a", "b", "c"));
  EXPECT_EQ(client_->waiting(), 1);
  held_->Answer("a", absl::UnavailableError(""));
  EXPECT_THAT(held_->Begun(4), ElementsAre("a", "b", "c", "d"));
  held_->Answer("c", ChatAnswer());
  held_->Answer("d", ChatAnswer());
}

TEST_F(LimitingLlmClientTest, ACallThatIsCancelledLeavesTheQueueAndIsNeverMade) {
  Limit({.in_flight = 1});
  runtime::CallContext other("", absl::InfiniteFuture(), clock_);
  Ask("a", call_);
  held_->Begun(1);
  AskInVain("b", other);
  AskInVain("c", call_, 1);
  other.cancellation().Cancel();
  EXPECT_TRUE(absl::IsCancelled(End("b")));
  held_->Answer("a", ChatAnswer());
  EXPECT_THAT(held_->Begun(2), ElementsAre("a", "c"));
  held_->Answer("c", ChatAnswer());
}

TEST_F(LimitingLlmClientTest, ACallWhoseDeadlineComesInTheQueueEndsThen) {
  Limit({.in_flight = 1});
  runtime::CallContext hasty("", clock_.Now() + absl::Seconds(3), clock_);
  Ask("a", call_);
  held_->Begun(1);
  AskInVain("b", hasty);
  clock_.Advance(absl::Seconds(2));
  EXPECT_EQ(client_->waiting(), 1);
  clock_.Advance(absl::Seconds(2));
  EXPECT_TRUE(absl::IsDeadlineExceeded(End("b")));
  held_->Answer("a", ChatAnswer());
}

TEST_F(LimitingLlmClientTest, ACallThatWasCancelledBeforeItCameLeavesToo) {
  Limit({.in_flight = 1});
  runtime::CallContext gone("", absl::InfiniteFuture(), clock_);
  gone.cancellation().Cancel();
  Ask("a", call_);
  held_->Begun(1);
  Ask("b", gone);
  EXPECT_TRUE(absl::IsCancelled(End("b")));
  held_->Answer("a", ChatAnswer());
}

TEST_F(LimitingLlmClientTest, TokensThatAreSpentComeBackEvenly) {
  Limit({.in_flight = 100, .tokens_per_minute = 600});
  Ask("a", call_);
  held_->Answer("a", Consuming(700));
  ASSERT_TRUE(End("a").ok());
  // 100 below empty, 10 a second.
  AskInVain("b", call_);
  clock_.Advance(absl::Seconds(10));
  EXPECT_THAT(held_->Begun(0), ElementsAre("a"));
  EXPECT_EQ(client_->waiting(), 1);
  clock_.Advance(absl::Seconds(0.2));
  EXPECT_THAT(held_->Begun(2), ElementsAre("a", "b"));
  held_->Answer("b", ChatAnswer());
}

TEST_F(LimitingLlmClientTest, AMinuteWithoutCallsSavesNoMoreThanAMinutesTokens) {
  Limit({.in_flight = 100, .tokens_per_minute = 600});
  clock_.Advance(absl::Hours(5));
  Ask("a", call_);
  held_->Answer("a", Consuming(1200));
  ASSERT_TRUE(End("a").ok());
  AskInVain("b", call_);
  clock_.Advance(absl::Seconds(59));
  EXPECT_EQ(client_->waiting(), 1);
  clock_.Advance(absl::Seconds(2));
  EXPECT_THAT(held_->Begun(2), ElementsAre("a", "b"));
  held_->Answer("b", ChatAnswer());
}

TEST_F(LimitingLlmClientTest, QuestionsInFlightCountBeforeTheirAnswers) {
  Limit({.in_flight = 100, .tokens_per_minute = 4});
  Ask("a long question", call_);
  held_->Begun(1);
  AskInVain("b", call_);
  EXPECT_THAT(held_->Begun(0), SizeIs(1));
  call_.cancellation().Cancel();
  EXPECT_TRUE(absl::IsCancelled(End("b")));
  held_->Answer("a long question", ChatAnswer());
}

}  // namespace
}  // namespace flair::llm
