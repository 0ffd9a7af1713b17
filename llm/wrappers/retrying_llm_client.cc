// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/wrappers/retrying_llm_client.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <utility>

#include "fmt/format.h"
#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::llm {
namespace {

// In [0, 1), decided by the text alone.
double Spread(const std::string& text) {
  const std::string digest = runtime::Sha256Hex(text);
  return static_cast<double>(std::stoull(digest.substr(0, 12), nullptr, 16)) / static_cast<double>(1ULL << 48);
}

absl::Status AfterAttempts(const absl::Status& failure, int attempts) {
  if (attempts == 1) return failure;
  return absl::Status(failure.code(), fmt::format("{} (after {} attempts)", std::string(failure.message()), attempts));
}

}  // namespace

std::optional<absl::Duration> RetryPolicy::DelayAfter(const absl::Status& failure, int attempt,
                                                      const std::string& key) const {
  if (!absl::IsUnavailable(failure) || attempt >= attempt_limit) return std::nullopt;
  const std::optional<absl::Duration> asked = RetryAfter(failure);
  if (asked.has_value() && *asked > longest_delay) return std::nullopt;
  absl::Duration own = first_delay;
  for (int i = 1; i < attempt && own < longest_delay; ++i) own *= 2;
  const double spread = 1 + 0.5 * Spread(fmt::format("{}#{}", key, attempt));
  return std::max(asked.value_or(absl::ZeroDuration()), std::min(own, longest_delay)) * spread;
}

void WaitOrCancelled(absl::Duration delay, runtime::CallContext& call) {
  std::mutex mutex;
  std::condition_variable wake;
  const runtime::OnCancel on_cancel(call.cancellation(), [&] {
    const std::lock_guard lock(mutex);
    wake.notify_all();
  });
  std::unique_lock lock(mutex);
  wake.wait_for(lock, absl::ToChronoMilliseconds(delay), [&] { return call.cancellation().cancelled(); });
}

RetryingLlmClient::RetryingLlmClient(std::unique_ptr<LlmClient> inner, RetryPolicy policy, const runtime::Clock& clock,
                                     Wait wait)
    : LlmClientWrapper(std::move(inner)), policy_(policy), clock_(clock), wait_(std::move(wait)) {}

absl::StatusOr<ChatAnswer> RetryingLlmClient::Ask(const ChatRequest& request, runtime::CallContext& call) {
  for (int attempt = 1;; ++attempt) {
    absl::StatusOr<ChatAnswer> answer = inner_->Ask(request, call);
    if (answer.ok()) return answer;
    const std::optional<absl::Duration> delay =
        policy_.DelayAfter(answer.status(), attempt, call.request_id() + "/" + request.step);
    if (!delay.has_value() || clock_.Now() + *delay >= call.deadline()) {
      return AfterAttempts(answer.status(), attempt);
    }
    wait_(*delay, call);
    RETURN_IF_ERROR(call.CheckAlive());
  }
}

}  // namespace flair::llm
