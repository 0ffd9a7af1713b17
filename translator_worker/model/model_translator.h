// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "absl/status/statusor.h"
#include "flair/config/v1/translator_worker_config.pb.h"
#include "flair/v1/translator_service.pb.h"
#include "llm/answers/prompt_library.h"
#include "llm/client/llm_client.h"
#include "translator_worker/service/make_translator_service.h"
#include "worker_runtime/bootstrap/worker_context.h"
#include "worker_runtime/config/config_reader.h"

namespace flair::translator {

// Translates with a language model: one question for the sentences of each scope, all asked at once, each with at most
// one repair. Every call is checked against the catalogue; what does not fit is left out, with a diagnostic that quotes
// its sentence and says why. Thread-safe.
class ModelTranslator final : public Translator {
 public:
  // Reads the prompts; errors as PromptLibrary::Load. `overrides` may be empty.
  static absl::StatusOr<std::unique_ptr<ModelTranslator>> Make(std::unique_ptr<llm::LlmClient> client,
                                                               const std::filesystem::path& prompts,
                                                               const std::filesystem::path& overrides);

  // The graph and the record of calls of a valid request whose catalogue is set. A pass whose model fails fails the
  // whole, as Conversation says, unless the request allows a stand-in: then the grammar reads its sentences, and a
  // diagnostic says so.
  absl::StatusOr<v1::TranslateResponse> Translate(const v1::TranslateRequest& request,
                                                  runtime::CallContext& call) const override;

  std::string model() const override { return client_->identity(); }
  std::string version() const override { return prompts_.version(); }

 private:
  ModelTranslator(std::unique_ptr<llm::LlmClient> client, llm::PromptLibrary prompts)
      : client_(std::move(client)), prompts_(std::move(prompts)) {}

  const std::unique_ptr<llm::LlmClient> client_;
  const llm::PromptLibrary prompts_;
};

// The prompts that come with the program.
std::filesystem::path DefaultPromptFolder();

// For MakeTranslatorService: the model of config.llm; errors as llm::MakeLlmClient and PromptLibrary::Load.
absl::StatusOr<std::unique_ptr<const Translator>> MakeModelTranslator(const config::v1::TranslatorWorkerConfig& config,
                                                                      runtime::WorkerContext& worker);

// Reports what is wrong with the config, but for its runtime.
void CheckTranslatorConfig(const config::v1::TranslatorWorkerConfig& config, runtime::ConfigChecker& checker);

}  // namespace flair::translator
