// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <string>

#include "llm/client/llm_client.h"
#include "worker_runtime/clock/clock.h"

namespace flair::llm {

struct CallLimits {
  // At most so many calls at once.
  int in_flight = 16;
  // At most so many tokens a minute, questions and answers; 0 means any number.
  int64_t tokens_per_minute = 0;
};

// Lets calls through in the order in which they came, as the limits allow; the others wait without a thread. Tokens are
// a bucket that holds one minute's worth and fills evenly: a call may begin while anything is in it, takes the estimate
// of its question, and settles the difference when the answer says what it consumed, so that the bucket can fall below
// 0.
class LimitingLlmClient final : public LlmClient {
 public:
  // `timer` and `clock` outlive it; the timer must have stopped before it is destroyed.
  LimitingLlmClient(std::unique_ptr<LlmClient> inner, CallLimits limits, runtime::Timer& timer,
                    const runtime::Clock& clock);

  void Ask(const ChatRequest& request, runtime::CallContext& call, AnswerCallback done) override;
  std::string identity() const override { return inner_->identity(); }

 private:
  struct Waiting;

  void Queue(std::shared_ptr<Waiting> waiting);
  // Ends the wait of a call that was cancelled or whose deadline has come.
  void Leave(const std::shared_ptr<Waiting>& waiting, absl::Status status);
  // Begins what may begin now. Only in the timer's thread: the call that made room for another may be within a
  // cancellation that the other shares.
  void Pump();
  // One timer does for all that wait.
  void PumpWhenTokensReturn();
  void Start(const ChatRequest& request, runtime::CallContext& call, int64_t estimate, AnswerCallback done);

  // With mutex_ held.
  bool TakeTurn(int64_t estimate);
  void Refill();
  // When there will be tokens again; zero when there are.
  absl::Duration TokensReturnAfter() const;

  const CallLimits limits_;
  runtime::Timer& timer_;
  const runtime::Clock& clock_;

  std::mutex mutex_;
  std::deque<std::shared_ptr<Waiting>> queue_;
  int in_flight_ = 0;
  double tokens_;
  absl::Duration filled_at_;
  // When a timer pumps next; infinite when none does.
  absl::Duration next_pump_ = absl::InfiniteDuration();

  const std::unique_ptr<LlmClient> inner_;
};

}  // namespace flair::llm
