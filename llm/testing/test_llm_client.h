// SPDX-License-Identifier: GPL-3.0-or-later
// For the tests of this folder: a model that answers as the test says.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "llm/client/llm_client.h"

namespace flair::llm {

// Keeps what it was asked, and answers with `answer`. Not thread-safe.
class TestLlmClient final : public LlmClient {
 public:
  absl::StatusOr<ChatAnswer> Ask(const ChatRequest& request, runtime::CallContext& call) override {
    requests.push_back(request);
    deadlines.push_back(call.deadline());
    return answer(requests.size());
  }
  std::string identity() const override { return "held@test"; }

  std::vector<ChatRequest> requests;
  // Of their calls.
  std::vector<absl::Time> deadlines;
  // Takes the number of the request, from 1.
  std::function<absl::StatusOr<ChatAnswer>(size_t number)> answer;
};

inline ChatRequest AskFor(const std::string& step) {
  ChatRequest request;
  request.step = step;
  request.messages = {{Role::kUser, "about " + step}};
  return request;
}

}  // namespace flair::llm
