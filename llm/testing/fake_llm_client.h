// SPDX-License-Identifier: GPL-3.0-or-later
// A model for tests that answers from a script.
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "llm/client/llm_client.h"

namespace flair::llm {

// Answers each step's calls, in their order, with what was scripted for the step ("zones", "zones/repair"); a call that
// nothing is scripted for fails with NOT_FOUND. Keeps what it was asked. Thread-safe.
class FakeLlmClient final : public LlmClient {
 public:
  void Answer(const std::string& step, std::string text, FinishReason finish = FinishReason::kStop) {
    ChatAnswer answer;
    answer.text = std::move(text);
    answer.finish = finish;
    answer.model = "fake-1";
    Answer(step, std::move(answer));
  }
  void Answer(const std::string& step, absl::StatusOr<ChatAnswer> answer) {
    const std::lock_guard lock(mutex_);
    script_[step].push_back(std::move(answer));
  }

  // Takes back what was scripted for the step and not yet asked for.
  void Forget(const std::string& step) {
    const std::lock_guard lock(mutex_);
    script_.erase(step);
  }

  absl::StatusOr<ChatAnswer> Ask(const ChatRequest& request, runtime::CallContext&) override {
    absl::StatusOr<ChatAnswer> answer = absl::NotFoundError("nothing is scripted for step \"" + request.step + "\"");
    {
      const std::lock_guard lock(mutex_);
      requests_.push_back(request);
      auto& scripted = script_[request.step];
      if (!scripted.empty()) {
        answer = std::move(scripted.front());
        scripted.erase(scripted.begin());
      }
    }
    if (answer.ok() && answer->usage.input_token_count == 0) {
      for (const Message& message : request.messages) answer->usage.input_token_count += EstimateTokens(message.text);
      answer->usage.output_token_count = EstimateTokens(answer->text);
      answer->usage.estimated = true;
    }
    return answer;
  }

  std::string identity() const override { return "fake-1"; }

  // What it was asked so far, in order.
  std::vector<ChatRequest> requests() const {
    const std::lock_guard lock(mutex_);
    return requests_;
  }

 private:
  mutable std::mutex mutex_;
  std::map<std::string, std::vector<absl::StatusOr<ChatAnswer>>> script_;
  std::vector<ChatRequest> requests_;
};

}  // namespace flair::llm
