// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/wrappers/recording_llm_client.h"

#include <utility>

namespace flair::llm {

absl::StatusOr<std::unique_ptr<LlmClient>> RecordingLlmClient::Make(std::unique_ptr<LlmClient> inner,
                                                                    const std::string& path) {
  if (absl::Status status = AnswerFolder(path).ClaimFor(inner->identity()); !status.ok()) return status;
  return std::unique_ptr<LlmClient>(new RecordingLlmClient(std::move(inner), path));
}

RecordingLlmClient::RecordingLlmClient(std::unique_ptr<LlmClient> inner, const std::string& path)
    : folder_(path), inner_(std::move(inner)) {}

void RecordingLlmClient::Ask(const ChatRequest& request, runtime::CallContext& call, AnswerCallback done) {
  absl::StatusOr<std::optional<ChatAnswer>> known = folder_.Find(request);
  if (!known.ok() || known->has_value()) {
    done(known.ok() ? absl::StatusOr<ChatAnswer>(**std::move(known)) : known.status());
    return;
  }
  inner_->Ask(request, call, [this, request, done = std::move(done)](absl::StatusOr<ChatAnswer> answer) {
    if (answer.ok()) answer = folder_.Put(request, *answer);
    done(std::move(answer));
  });
}

}  // namespace flair::llm
