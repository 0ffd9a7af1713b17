// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>

#include "llm/client/llm_client.h"
#include "worker_runtime/clock/clock.h"

namespace flair::llm {

struct CallLimits {
  // At most so many calls at once.
  int in_flight = 16;
  // At most so many tokens a minute, questions and answers; 0 means any number.
  int64_t tokens_per_minute = 0;
};

// Lets calls through in the order in which they came, as the limits allow. Tokens are a bucket that holds one minute's
// worth and fills evenly: a call may begin while anything is in it, takes the estimate of its question, and settles the
// difference when the answer says what it consumed, so that the bucket can fall below 0.
class LimitingLlmClient final : public LlmClientWrapper {
 public:
  // `clock` outlives it.
  LimitingLlmClient(std::unique_ptr<LlmClient> inner, CallLimits limits, const runtime::Clock& clock);

  absl::StatusOr<ChatAnswer> Ask(const ChatRequest& request, runtime::CallContext& call) override;

  // Calls that wait for their turn; for tests.
  int waiting() const;

 private:
  // OK when the call may begin.
  absl::Status WaitForTurn(int64_t estimate, runtime::CallContext& call);

  // With mutex_ held.
  void Refill();
  bool HasTokens() const { return limits_.tokens_per_minute == 0 || tokens_ > 0; }

  const CallLimits limits_;
  const runtime::Clock& clock_;

  mutable std::mutex mutex_;
  // Some call has ended or left the queue, or was cancelled.
  std::condition_variable changed_;
  // Those that wait, by number.
  std::deque<int64_t> queue_;
  int64_t next_number_ = 0;
  int in_flight_ = 0;
  double tokens_;
  absl::Duration filled_at_;
};

}  // namespace flair::llm
