// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "llm/client/llm_client.h"
#include "worker_runtime/clock/clock.h"

namespace flair::llm {

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
