// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "flair/config/v1/llm_config.pb.h"
#include "llm/client/llm_client.h"
#include "llm/config/check_llm_config.h"
#include "worker_runtime/clock/clock.h"
#include "worker_runtime/metrics/metrics.h"

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

// What calls consume: in metrics, and in money.

// Counts calls by outcome, tokens and dollars, and measures how long answers take.
class MeteredLlmClient final : public LlmClientWrapper {
 public:
  MeteredLlmClient(std::unique_ptr<LlmClient> inner, runtime::Metrics& metrics, const runtime::Clock& clock);

  absl::StatusOr<ChatAnswer> Ask(const ChatRequest& request, runtime::CallContext& call) override;

 private:
  runtime::Metrics& metrics_;
  runtime::Counter& input_tokens_;
  runtime::Counter& cached_input_tokens_;
  runtime::Counter& output_tokens_;
  runtime::Counter& cost_dollars_;
  runtime::Histogram& duration_;
  const runtime::Clock& clock_;
};

// Writes into every answer what it cost. `model` is the configured name, used when the server's own has no price.
class PricedLlmClient final : public LlmClientWrapper {
 public:
  PricedLlmClient(std::unique_ptr<LlmClient> inner, std::vector<config::v1::LlmPrice> prices, std::string model);

  absl::StatusOr<ChatAnswer> Ask(const ChatRequest& request, runtime::CallContext& call) override;

 private:
  const std::vector<config::v1::LlmPrice> prices_;
  const std::string model_;
};

// When a call is made again: after UNAVAILABLE, which stands for an overloaded or unreachable server.
struct RetryPolicy {
  int attempt_limit = 5;
  // Before the second attempt; doubles from there.
  absl::Duration first_delay = absl::Milliseconds(500);
  // Most that is waited, also when the server asks for more; such an answer ends the call at once.
  absl::Duration longest_delay = absl::Seconds(60);

  // How long to wait after the failure of attempt `attempt` (1 is the first); nothing when there is no other. What the
  // server asks for counts when it is longer. Spread by up to a half of itself, upwards, by `key`: callers that failed
  // together do not come back together.
  std::optional<absl::Duration> DelayAfter(const absl::Status& failure, int attempt, const std::string& key) const;
};

// Waits so long, or until the call is cancelled.
void WaitOrCancelled(absl::Duration delay, runtime::CallContext& call);

// Asks again by a policy; between attempts it holds nothing that another call waits for. A wait that would outlast the
// call's deadline is not begun: the last failure is returned, saying how many attempts were made.
class RetryingLlmClient final : public LlmClientWrapper {
 public:
  using Wait = std::function<void(absl::Duration delay, runtime::CallContext& call)>;

  // `clock` outlives it. `wait` is another in tests.
  RetryingLlmClient(std::unique_ptr<LlmClient> inner, RetryPolicy policy, const runtime::Clock& clock,
                    Wait wait = WaitOrCancelled);

  absl::StatusOr<ChatAnswer> Ask(const ChatRequest& request, runtime::CallContext& call) override;

 private:
  const RetryPolicy policy_;
  const runtime::Clock& clock_;
  const Wait wait_;
};

}  // namespace flair::llm
