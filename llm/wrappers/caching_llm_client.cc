// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/wrappers/caching_llm_client.h"

#include <utility>

#include "worker_runtime/files/files.h"

namespace flair::llm {

CachingLlmClient::CachingLlmClient(std::unique_ptr<LlmClient> inner, const std::string& path)
    : folder_(path + "/" + runtime::Sha256Hex(inner->identity()).substr(0, 16)), inner_(std::move(inner)) {}

void CachingLlmClient::Ask(const ChatRequest& request, runtime::CallContext& call, AnswerCallback done) {
  absl::StatusOr<std::optional<ChatAnswer>> known = folder_.Find(request);
  if (known.ok() && known->has_value()) {
    done(**std::move(known));
    return;
  }
  inner_->Ask(request, call, [this, request, done = std::move(done)](absl::StatusOr<ChatAnswer> answer) {
    if (answer.ok()) {
      // When two callers asked the same at once, both get what is kept.
      absl::StatusOr<ChatAnswer> kept = folder_.Put(request, *answer);
      if (kept.ok()) answer = *std::move(kept);
    }
    done(std::move(answer));
  });
}

}  // namespace flair::llm
