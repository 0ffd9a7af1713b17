// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/wrappers/replaying_llm_client.h"

#include <utility>

#include "fmt/format.h"

namespace flair::llm {

absl::StatusOr<std::unique_ptr<LlmClient>> ReplayingLlmClient::Make(const std::string& path) {
  absl::StatusOr<std::string> identity = AnswerFolder(path).Identity();
  if (!identity.ok()) return identity.status();
  return std::unique_ptr<LlmClient>(new ReplayingLlmClient(path, *std::move(identity)));
}

ReplayingLlmClient::ReplayingLlmClient(const std::string& path, std::string identity)
    : folder_(path), identity_(std::move(identity)) {}

absl::StatusOr<std::optional<ChatAnswer>> ReplayingLlmClient::Find(const ChatRequest& request) const {
  absl::StatusOr<std::optional<ChatAnswer>> known = folder_.Find(request);
  if (request.seed == 0 || !known.ok() || known->has_value()) return known;
  ChatRequest of_any_seed = request;
  of_any_seed.seed = 0;
  return folder_.Find(of_any_seed);
}

void ReplayingLlmClient::Ask(const ChatRequest& request, runtime::CallContext& call, AnswerCallback done) {
  if (absl::Status alive = call.CheckAlive(); !alive.ok()) {
    done(std::move(alive));
    return;
  }
  absl::StatusOr<std::optional<ChatAnswer>> known = Find(request);
  if (!known.ok()) {
    done(known.status());
  } else if (!known->has_value()) {
    done(absl::NotFoundError(fmt::format(
        "{}: no recorded answer for step \"{}\"{}: expected the file {}", folder_.path(), request.step,
        request.seed == 0 ? "" : fmt::format(" with seed {}", request.seed), AnswerFolder::FileName(request))));
  } else {
    done(**std::move(known));
  }
}

}  // namespace flair::llm
