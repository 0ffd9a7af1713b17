// SPDX-License-Identifier: GPL-3.0-or-later
// For tests: a model that answers when the test says so.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "llm/client/llm_client.h"

namespace flair::llm {

// Holds every call until the test answers it. Not thread-safe: for tests of one thread.
class HeldLlmClient final : public LlmClient {
 public:
  void Ask(const ChatRequest& request, runtime::CallContext& call, AnswerCallback done) override {
    requests.push_back(request);
    dones_.push_back(std::move(done));
  }
  std::string identity() const override { return "held@test"; }

  // Answers call number `index`, counted from 0.
  void Answer(size_t index, absl::StatusOr<ChatAnswer> answer) { std::exchange(dones_[index], {})(std::move(answer)); }
  void Answer(size_t index, const std::string& text) {
    ChatAnswer answer;
    answer.text = text;
    Answer(index, std::move(answer));
  }

  std::vector<ChatRequest> requests;

 private:
  std::vector<AnswerCallback> dones_;
};

inline ChatRequest AskFor(const std::string& step) {
  ChatRequest request;
  request.step = step;
  request.messages = {{Role::kUser, "about " + step}};
  return request;
}

}  // namespace flair::llm
