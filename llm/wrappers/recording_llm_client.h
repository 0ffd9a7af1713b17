// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "llm/client/llm_client.h"
#include "llm/wrappers/answer_folder.h"

namespace flair::llm {

// Writes every answer into a folder from which ReplayingLlmClient gives them again. A request that the folder has is
// not asked again, so that a recording says one thing only. An answer that cannot be written is an error: a recording
// with a hole is none.
class RecordingLlmClient final : public LlmClient {
 public:
  // Errors as AnswerFolder::ClaimFor.
  static absl::StatusOr<std::unique_ptr<LlmClient>> Make(std::unique_ptr<LlmClient> inner, const std::string& path);

  void Ask(const ChatRequest& request, runtime::CallContext& call, AnswerCallback done) override;
  std::string identity() const override { return inner_->identity(); }

 private:
  RecordingLlmClient(std::unique_ptr<LlmClient> inner, const std::string& path);

  const AnswerFolder folder_;
  const std::unique_ptr<LlmClient> inner_;
};

}  // namespace flair::llm
