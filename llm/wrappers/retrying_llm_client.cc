// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/wrappers/retrying_llm_client.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "fmt/format.h"
#include "llm/client/retry_hint.h"
#include "llm/wrappers/timed_wait.h"
#include "worker_runtime/files/files.h"

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

struct RetryingLlmClient::Pending {
  ChatRequest request;
  runtime::CallContext& call;
  AnswerCallback done;
  int attempt = 0;
  // Set while it waits for the next attempt.
  std::unique_ptr<TimedWait> wait = nullptr;
};

RetryingLlmClient::RetryingLlmClient(std::unique_ptr<LlmClient> inner, RetryPolicy policy, runtime::Timer& timer,
                                     const runtime::Clock& clock)
    : policy_(policy), timer_(timer), clock_(clock), inner_(std::move(inner)) {}

void RetryingLlmClient::Ask(const ChatRequest& request, runtime::CallContext& call, AnswerCallback done) {
  Try(std::make_shared<Pending>(Pending{request, call, std::move(done)}));
}

void RetryingLlmClient::Try(std::shared_ptr<Pending> pending) {
  ++pending->attempt;
  inner_->Ask(pending->request, pending->call,
              [this, pending](absl::StatusOr<ChatAnswer> answer) { Decide(pending, std::move(answer)); });
}

void RetryingLlmClient::Decide(std::shared_ptr<Pending> pending, absl::StatusOr<ChatAnswer> answer) {
  const std::optional<absl::Duration> delay =
      answer.ok() ? std::nullopt
                  : policy_.DelayAfter(answer.status(), pending->attempt,
                                       pending->call.request_id() + "/" + pending->request.step);
  if (!delay.has_value() || clock_.Now() + *delay >= pending->call.deadline()) {
    if (!answer.ok()) answer = AfterAttempts(answer.status(), pending->attempt);
    pending->done(std::move(answer));
    return;
  }
  pending->wait = std::make_unique<TimedWait>(timer_, pending->call.cancellation());
  pending->wait->Begin(*delay, [this, pending](const absl::Status& status) {
    pending->wait.reset();
    absl::Status alive = status.ok() ? pending->call.CheckAlive() : status;
    if (!alive.ok()) {
      pending->done(std::move(alive));
      return;
    }
    Try(pending);
  });
}

}  // namespace flair::llm
