// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/client/llm_client.h"

#include <condition_variable>
#include <mutex>
#include <utility>

namespace flair::llm {

int64_t EstimateTokens(const std::string& text) { return static_cast<int64_t>((text.size() + 3) / 4); }

int64_t EstimateTokens(const ChatRequest& request) {
  int64_t tokens = EstimateTokens(request.schema);
  for (const Message& message : request.messages) tokens += EstimateTokens(message.text);
  return tokens;
}

absl::StatusOr<ChatAnswer> AskAndWait(LlmClient& client, const ChatRequest& request, runtime::CallContext& call) {
  return std::move(AskAllAndWait(client, {&request, 1}, call).front());
}

std::vector<absl::StatusOr<ChatAnswer>> AskAllAndWait(LlmClient& client, std::span<const ChatRequest> requests,
                                                      runtime::CallContext& call) {
  std::vector<absl::StatusOr<ChatAnswer>> answers(requests.size(), absl::StatusOr<ChatAnswer>(absl::UnknownError("")));
  std::mutex mutex;
  std::condition_variable all_done;
  size_t waiting = requests.size();
  for (size_t i = 0; i < requests.size(); ++i) {
    client.Ask(requests[i], call, [&, i](absl::StatusOr<ChatAnswer> answer) {
      // Notifies under the lock: the waiter may destroy the condition as soon as it sees the last answer.
      const std::lock_guard lock(mutex);
      answers[i] = std::move(answer);
      if (--waiting == 0) all_done.notify_one();
    });
  }
  std::unique_lock lock(mutex);
  all_done.wait(lock, [&] { return waiting == 0; });
  return answers;
}

}  // namespace flair::llm
