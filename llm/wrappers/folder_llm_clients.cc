// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/wrappers/folder_llm_clients.h"

#include <utility>

#include "fmt/format.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::llm {

CachingLlmClient::CachingLlmClient(std::unique_ptr<LlmClient> inner, const std::string& path)
    : LlmClientWrapper(std::move(inner)), folder_(path + "/" + runtime::Sha256Hex(identity()).substr(0, 16)) {}

absl::StatusOr<ChatAnswer> CachingLlmClient::Ask(const ChatRequest& request, runtime::CallContext& call) {
  absl::StatusOr<std::optional<ChatAnswer>> known = folder_.Find(request);
  if (known.ok() && known->has_value()) return **std::move(known);
  ASSIGN_OR_RETURN(ChatAnswer answer, inner_->Ask(request, call));
  // When two callers asked the same at once, both get what is kept.
  absl::StatusOr<ChatAnswer> kept = folder_.Put(request, answer);
  return kept.ok() ? *std::move(kept) : std::move(answer);
}

absl::StatusOr<std::unique_ptr<LlmClient>> RecordingLlmClient::Make(std::unique_ptr<LlmClient> inner,
                                                                    const std::string& path) {
  RETURN_IF_ERROR(AnswerFolder(path).ClaimFor(inner->identity()));
  return std::unique_ptr<LlmClient>(new RecordingLlmClient(std::move(inner), path));
}

RecordingLlmClient::RecordingLlmClient(std::unique_ptr<LlmClient> inner, const std::string& path)
    : LlmClientWrapper(std::move(inner)), folder_(path) {}

absl::StatusOr<ChatAnswer> RecordingLlmClient::Ask(const ChatRequest& request, runtime::CallContext& call) {
  ASSIGN_OR_RETURN(std::optional<ChatAnswer> known, folder_.Find(request));
  if (known.has_value()) return *std::move(known);
  ASSIGN_OR_RETURN(const ChatAnswer answer, inner_->Ask(request, call));
  return folder_.Put(request, answer);
}

absl::StatusOr<std::unique_ptr<LlmClient>> ReplayingLlmClient::Make(const std::string& path) {
  ASSIGN_OR_RETURN(std::string identity, AnswerFolder(path).Identity());
  return std::unique_ptr<LlmClient>(new ReplayingLlmClient(path, std::move(identity)));
}

ReplayingLlmClient::ReplayingLlmClient(const std::string& path, std::string identity)
    : folder_(path), identity_(std::move(identity)) {}

absl::StatusOr<std::optional<ChatAnswer>> ReplayingLlmClient::Find(const ChatRequest& request) const {
  ASSIGN_OR_RETURN(std::optional<ChatAnswer> known, folder_.Find(request));
  if (request.seed == 0 || known.has_value()) return known;
  ChatRequest of_any_seed = request;
  of_any_seed.seed = 0;
  return folder_.Find(of_any_seed);
}

absl::StatusOr<ChatAnswer> ReplayingLlmClient::Ask(const ChatRequest& request, runtime::CallContext& call) {
  RETURN_IF_ERROR(call.CheckAlive());
  ASSIGN_OR_RETURN(std::optional<ChatAnswer> known, Find(request));
  if (known.has_value()) return *std::move(known);
  return absl::NotFoundError(fmt::format(
      "{}: no recorded answer for step \"{}\"{}: expected the file {}", folder_.path(), request.step,
      request.seed == 0 ? "" : fmt::format(" with seed {}", request.seed), AnswerFolder::FileName(request)));
}

}  // namespace flair::llm
