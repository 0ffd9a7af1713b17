// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/wrappers/limiting_llm_client.h"

#include <algorithm>
#include <utility>

#include "llm/wrappers/timed_wait.h"

namespace flair::llm {
namespace {

// Calls without a deadline need no end of their wait.
constexpr absl::Duration kLongestWait = absl::Hours(24);

}  // namespace

struct LimitingLlmClient::Waiting {
  enum class State { kNew, kQueued, kEnded };
  ChatRequest request;
  runtime::CallContext& call;
  AnswerCallback done;
  int64_t estimate = 0;
  // With the client's mutex held.
  State state = State::kNew;
  // To its deadline.
  std::unique_ptr<TimedWait> wait = nullptr;
};

LimitingLlmClient::LimitingLlmClient(std::unique_ptr<LlmClient> inner, CallLimits limits, runtime::Timer& timer,
                                     const runtime::Clock& clock)
    : limits_(limits),
      timer_(timer),
      clock_(clock),
      tokens_(static_cast<double>(limits.tokens_per_minute)),
      filled_at_(clock.Elapsed()),
      inner_(std::move(inner)) {}

void LimitingLlmClient::Ask(const ChatRequest& request, runtime::CallContext& call, AnswerCallback done) {
  const int64_t estimate = EstimateTokens(request);
  const bool at_once = [&] {
    const std::lock_guard lock(mutex_);
    return queue_.empty() && TakeTurn(estimate);
  }();
  if (at_once) {
    Start(request, call, estimate, std::move(done));
  } else {
    Queue(std::make_shared<Waiting>(Waiting{request, call, std::move(done), estimate}));
  }
}

void LimitingLlmClient::Queue(std::shared_ptr<Waiting> waiting) {
  const absl::Duration until_deadline = std::min(waiting->call.deadline() - clock_.Now(), kLongestWait);
  waiting->wait = std::make_unique<TimedWait>(timer_, waiting->call.cancellation());
  waiting->wait->Begin(until_deadline, [this, waiting](const absl::Status& status) {
    Leave(waiting, status.ok() ? waiting->call.CheckAlive() : status);
  });
  {
    const std::lock_guard lock(mutex_);
    if (waiting->state != Waiting::State::kNew) return;
    waiting->state = Waiting::State::kQueued;
    queue_.push_back(std::move(waiting));
    Refill();
  }
  // Also when only a slot was missing: it may have come free since.
  PumpWhenTokensReturn();
}

void LimitingLlmClient::PumpWhenTokensReturn() {
  absl::Duration after, due;
  {
    const std::lock_guard lock(mutex_);
    after = TokensReturnAfter();
    due = clock_.Elapsed() + after;
    if (due >= next_pump_) return;
    next_pump_ = due;
  }
  timer_.RunAfter(after, [this, due](const absl::Status&) {
    {
      const std::lock_guard lock(mutex_);
      if (next_pump_ == due) next_pump_ = absl::InfiniteDuration();
    }
    Pump();
  });
}

void LimitingLlmClient::Leave(const std::shared_ptr<Waiting>& waiting, absl::Status status) {
  {
    const std::lock_guard lock(mutex_);
    if (waiting->state == Waiting::State::kEnded) return;
    waiting->state = Waiting::State::kEnded;
    std::erase(queue_, waiting);
  }
  waiting->wait.reset();
  if (status.ok()) status = absl::DeadlineExceededError("the call waited a day for its turn");
  waiting->done(std::move(status));
}

void LimitingLlmClient::Pump() {
  while (true) {
    std::shared_ptr<Waiting> next;
    bool for_tokens = false;
    {
      const std::lock_guard lock(mutex_);
      if (queue_.empty()) return;
      if (TakeTurn(queue_.front()->estimate)) {
        next = std::move(queue_.front());
        queue_.pop_front();
        next->state = Waiting::State::kEnded;
      } else {
        for_tokens = TokensReturnAfter() > absl::ZeroDuration();
      }
    }
    if (next == nullptr) {
      // Else the end of a call pumps.
      if (for_tokens) PumpWhenTokensReturn();
      return;
    }
    next->wait->Hasten();
    next->wait.reset();
    Start(next->request, next->call, next->estimate, std::move(next->done));
  }
}

void LimitingLlmClient::Start(const ChatRequest& request, runtime::CallContext& call, int64_t estimate,
                              AnswerCallback done) {
  inner_->Ask(request, call, [this, estimate, done = std::move(done)](absl::StatusOr<ChatAnswer> answer) {
    bool others_wait = false;
    {
      const std::lock_guard lock(mutex_);
      --in_flight_;
      if (answer.ok()) {
        const int64_t consumed = answer->usage.input_token_count + answer->usage.output_token_count;
        tokens_ -= static_cast<double>(consumed - estimate);
      }
      others_wait = !queue_.empty();
    }
    if (others_wait) timer_.RunAfter(absl::ZeroDuration(), [this](const absl::Status&) { Pump(); });
    done(std::move(answer));
  });
}

bool LimitingLlmClient::TakeTurn(int64_t estimate) {
  Refill();
  if (in_flight_ >= limits_.in_flight || TokensReturnAfter() > absl::ZeroDuration()) return false;
  ++in_flight_;
  tokens_ -= static_cast<double>(estimate);
  return true;
}

void LimitingLlmClient::Refill() {
  const absl::Duration now = clock_.Elapsed();
  const auto rate = static_cast<double>(limits_.tokens_per_minute);
  tokens_ = std::min(rate, tokens_ + rate * absl::ToDoubleSeconds(now - filled_at_) / 60);
  filled_at_ = now;
}

absl::Duration LimitingLlmClient::TokensReturnAfter() const {
  if (limits_.tokens_per_minute == 0 || tokens_ > 0) return absl::ZeroDuration();
  // One token and a little, so that rounding cannot end the wait too early.
  return absl::Minutes(1) * ((1 - tokens_) / static_cast<double>(limits_.tokens_per_minute)) + absl::Milliseconds(1);
}

}  // namespace flair::llm
