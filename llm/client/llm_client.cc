// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/client/llm_client.h"

#include <algorithm>

#include "absl/strings/cord.h"
#include "absl/strings/numbers.h"
#include "worker_runtime/executor/executor.h"

namespace flair::llm {
namespace {

constexpr char kRetryAfterPayload[] = "flair.llm/retry_after_ms";

}  // namespace

int64_t EstimateTokens(const std::string& text) { return static_cast<int64_t>((text.size() + 3) / 4); }

int64_t EstimateTokens(const ChatRequest& request) {
  int64_t tokens = EstimateTokens(request.schema);
  for (const Message& message : request.messages) tokens += EstimateTokens(message.text);
  return tokens;
}

std::vector<absl::StatusOr<ChatAnswer>> AskAll(LlmClient& client, std::span<const ChatRequest> requests,
                                               runtime::CallContext& call) {
  std::vector<absl::StatusOr<ChatAnswer>> answers(requests.size(), absl::StatusOr<ChatAnswer>(absl::UnknownError("")));
  const int count = static_cast<int>(requests.size());
  const auto ask = [&](int i) { answers[i] = client.Ask(requests[i], call); };
  const int at_once = std::min(client.concurrency(), count);
  if (at_once <= 1) {
    for (int i = 0; i < count; ++i) ask(i);
    return answers;
  }
  runtime::BoundedExecutor executor(at_once, count);
  for (int i = 0; i < count; ++i) {
    // Without a thread for it, it is asked here.
    if (!executor.TrySubmit([&ask, i] { ask(i); })) ask(i);
  }
  executor.Stop();
  return answers;
}

void SetRetryAfter(absl::Status& status, absl::Duration delay) {
  const absl::Duration kept = std::clamp(delay, absl::ZeroDuration(), absl::Hours(24));
  const std::string milliseconds = std::to_string(absl::ToInt64Milliseconds(kept));
  // Not of a std::string: clang and GCC spell that constructor differently, and the library has GCC's.
  status.SetPayload(kRetryAfterPayload, absl::Cord(absl::string_view(milliseconds)));
}

std::optional<absl::Duration> RetryAfter(const absl::Status& status) {
  const auto payload = status.GetPayload(kRetryAfterPayload);
  int64_t milliseconds = 0;
  if (!payload.has_value() || !absl::SimpleAtoi(std::string(*payload), &milliseconds)) return std::nullopt;
  return absl::Milliseconds(milliseconds);
}

}  // namespace flair::llm
