// SPDX-License-Identifier: GPL-3.0-or-later
// Clients that keep answers in folders: a cache, a recording, and a replay of a recording.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "absl/status/statusor.h"
#include "llm/client/llm_client.h"
#include "llm/wrappers/answer_folder.h"

namespace flair::llm {

// Keeps answers on disk by the content of the request and by who answers; asks only what is not there. A cache that
// cannot be read or written is as if it were empty.
class CachingLlmClient final : public LlmClientWrapper {
 public:
  CachingLlmClient(std::unique_ptr<LlmClient> inner, const std::string& path);

  absl::StatusOr<ChatAnswer> Ask(const ChatRequest& request, runtime::CallContext& call) override;

 private:
  // A folder of its own for each identity.
  const AnswerFolder folder_;
};

// Writes every answer into a folder from which ReplayingLlmClient gives them again. A request that the folder has is
// not asked again, so that a recording says one thing only. An answer that cannot be written is an error: a recording
// with a hole is none.
class RecordingLlmClient final : public LlmClientWrapper {
 public:
  // Errors as AnswerFolder::ClaimFor.
  static absl::StatusOr<std::unique_ptr<LlmClient>> Make(std::unique_ptr<LlmClient> inner, const std::string& path);

  absl::StatusOr<ChatAnswer> Ask(const ChatRequest& request, runtime::CallContext& call) override;

 private:
  RecordingLlmClient(std::unique_ptr<LlmClient> inner, const std::string& path);

  const AnswerFolder folder_;
};

// Answers from a recording, without a network, and passes for the model that was recorded. What was recorded without a
// seed, or with seed 0, answers every seed. A request that the recording does not have is NOT_FOUND, naming the step
// and the file that is missing.
class ReplayingLlmClient final : public LlmClient {
 public:
  // Errors as AnswerFolder::Identity.
  static absl::StatusOr<std::unique_ptr<LlmClient>> Make(const std::string& path);

  absl::StatusOr<ChatAnswer> Ask(const ChatRequest& request, runtime::CallContext& call) override;
  std::string identity() const override { return identity_; }

 private:
  ReplayingLlmClient(const std::string& path, std::string identity);

  absl::StatusOr<std::optional<ChatAnswer>> Find(const ChatRequest& request) const;

  const AnswerFolder folder_;
  const std::string identity_;
};

}  // namespace flair::llm
