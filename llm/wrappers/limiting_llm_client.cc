// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/wrappers/limiting_llm_client.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::llm {
namespace {

// Deadlines and tokens are looked at so often; the end of a call and a cancellation wake at once.
constexpr std::chrono::milliseconds kLookAgain(50);

}  // namespace

LimitingLlmClient::LimitingLlmClient(std::unique_ptr<LlmClient> inner, CallLimits limits, const runtime::Clock& clock)
    : LlmClientWrapper(std::move(inner)),
      limits_(limits),
      clock_(clock),
      tokens_(static_cast<double>(limits.tokens_per_minute)),
      filled_at_(clock.Elapsed()) {}

absl::StatusOr<ChatAnswer> LimitingLlmClient::Ask(const ChatRequest& request, runtime::CallContext& call) {
  const int64_t estimate = EstimateTokens(request);
  RETURN_IF_ERROR(WaitForTurn(estimate, call));
  absl::StatusOr<ChatAnswer> answer = inner_->Ask(request, call);
  const std::lock_guard lock(mutex_);
  --in_flight_;
  if (answer.ok()) {
    const int64_t consumed = answer->usage.input_token_count + answer->usage.output_token_count;
    tokens_ -= static_cast<double>(consumed - estimate);
  }
  changed_.notify_all();
  return answer;
}

absl::Status LimitingLlmClient::WaitForTurn(int64_t estimate, runtime::CallContext& call) {
  const runtime::OnCancel wake_up(call.cancellation(), [this] {
    const std::lock_guard lock(mutex_);
    changed_.notify_all();
  });
  std::unique_lock lock(mutex_);
  const int64_t number = next_number_++;
  queue_.push_back(number);
  absl::Status status;
  while (true) {
    status = call.CheckAlive();
    Refill();
    const bool may_begin = queue_.front() == number && in_flight_ < limits_.in_flight && HasTokens();
    if (!status.ok() || may_begin) break;
    changed_.wait_for(lock, kLookAgain);
  }
  std::erase(queue_, number);
  // The next may have its turn too.
  changed_.notify_all();
  RETURN_IF_ERROR(status);
  ++in_flight_;
  tokens_ -= static_cast<double>(estimate);
  return absl::OkStatus();
}

int LimitingLlmClient::waiting() const {
  const std::lock_guard lock(mutex_);
  return static_cast<int>(queue_.size());
}

void LimitingLlmClient::Refill() {
  const absl::Duration now = clock_.Elapsed();
  const auto rate = static_cast<double>(limits_.tokens_per_minute);
  tokens_ = std::min(rate, tokens_ + rate * absl::ToDoubleSeconds(now - filled_at_) / 60);
  filled_at_ = now;
}

}  // namespace flair::llm
