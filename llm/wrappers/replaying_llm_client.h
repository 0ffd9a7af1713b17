// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "absl/status/statusor.h"
#include "llm/client/llm_client.h"
#include "llm/wrappers/answer_folder.h"

namespace flair::llm {

// Answers from a recording, without a network, and passes for the model that was recorded. What was recorded without a
// seed, or with seed 0, answers every seed. A request that the recording does not have is NOT_FOUND, naming the step and
// the file that is missing.
class ReplayingLlmClient final : public LlmClient {
 public:
  // Errors as AnswerFolder::Identity.
  static absl::StatusOr<std::unique_ptr<LlmClient>> Make(const std::string& path);

  void Ask(const ChatRequest& request, runtime::CallContext& call, AnswerCallback done) override;
  std::string identity() const override { return identity_; }

 private:
  absl::StatusOr<std::optional<ChatAnswer>> Find(const ChatRequest& request) const;

  ReplayingLlmClient(const std::string& path, std::string identity);

  const AnswerFolder folder_;
  const std::string identity_;
};

}  // namespace flair::llm
