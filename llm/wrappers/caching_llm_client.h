// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "llm/client/llm_client.h"
#include "llm/wrappers/answer_folder.h"

namespace flair::llm {

// Keeps answers on disk by the content of the request and by who answers; asks only what is not there. A cache that
// cannot be read or written is as if it were empty.
class CachingLlmClient final : public LlmClient {
 public:
  CachingLlmClient(std::unique_ptr<LlmClient> inner, const std::string& path);

  void Ask(const ChatRequest& request, runtime::CallContext& call, AnswerCallback done) override;
  std::string identity() const override { return inner_->identity(); }

 private:
  // A folder of its own for each identity.
  const AnswerFolder folder_;
  const std::unique_ptr<LlmClient> inner_;
};

}  // namespace flair::llm
