// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/translator_service.pb.h"
#include "llm/answers/prompt_library.h"
#include "llm/client/llm_client.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::translator {

// Translates with a language model: one question for the sentences of each scope, all asked at once, each with at most
// one repair. Every call is checked against the catalogue; what does not fit is left out, with a diagnostic that quotes
// its sentence and says why. Thread-safe.
class ModelTranslator {
 public:
  // Reads the prompts; errors as PromptLibrary::Load. `overrides` may be empty.
  static absl::StatusOr<std::unique_ptr<ModelTranslator>> Make(std::unique_ptr<llm::LlmClient> client,
                                                               const std::filesystem::path& prompts,
                                                               const std::filesystem::path& overrides);

  // The graph and the record of calls of a valid request whose catalogue is set. A pass whose model fails fails the
  // whole, as Conversation says, unless the request allows a stand-in: then the grammar reads its sentences, and a
  // diagnostic says so.
  absl::StatusOr<v1::TranslateResponse> Translate(const v1::TranslateRequest& request,
                                                  runtime::CallContext& call) const;

  // Who answers, for producers; and all that decides the answers, for the keys of results.
  std::string model() const { return client_->identity(); }
  std::string version() const { return prompts_.version(); }

 private:
  ModelTranslator(std::unique_ptr<llm::LlmClient> client, llm::PromptLibrary prompts)
      : client_(std::move(client)), prompts_(std::move(prompts)) {}

  const std::unique_ptr<llm::LlmClient> client_;
  const llm::PromptLibrary prompts_;
};

// The prompts that come with the program.
std::filesystem::path DefaultPromptFolder();

}  // namespace flair::translator
