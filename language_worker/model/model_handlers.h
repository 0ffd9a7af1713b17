// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "absl/status/statusor.h"
#include "flair/config/v1/language_worker_config.pb.h"
#include "flair/v1/language_service.pb.h"
#include "language_worker/model/model_tools.h"
#include "language_worker/service/language_handlers.h"
#include "llm/answers/prompt_library.h"
#include "llm/client/llm_client.h"
#include "worker_runtime/bootstrap/worker_context.h"
#include "worker_runtime/config/config_reader.h"

namespace flair::language {

// Asks a language model. A step that fails because of the model, and for no other reason, is answered by the handbook
// where the request allows that, and a remark "stand_in" says so. Thread-safe; every call to a model blocks its thread
// until the model has answered.
class ModelHandlers final : public LanguageHandlers {
 public:
  // `handbook` must outlive it.
  ModelHandlers(const Handbook& handbook, std::unique_ptr<llm::LlmClient> client, llm::PromptLibrary prompts);

 private:
  absl::StatusOr<v1::DescribeRoomResponse> Answer(const v1::DescribeRoomRequest& request,
                                                  runtime::CallContext& call) const override;
  absl::StatusOr<v1::PlanZonesResponse> Answer(const v1::PlanZonesRequest& request,
                                               runtime::CallContext& call) const override;
  absl::StatusOr<v1::ListObjectsResponse> Answer(const v1::ListObjectsRequest& request,
                                                 runtime::CallContext& call) const override;
  absl::StatusOr<v1::ChooseStyleResponse> Answer(const v1::ChooseStyleRequest& request,
                                                 runtime::CallContext& call) const override;
  absl::StatusOr<v1::ListConstraintsResponse> Answer(const v1::ListConstraintsRequest& request,
                                                     runtime::CallContext& call) const override;
  absl::StatusOr<v1::CleanConstraintsResponse> Answer(const v1::CleanConstraintsRequest& request,
                                                      runtime::CallContext& call) const override;

  // Asks with `ask(Conversation&)`, which returns the artifact that `part` of the response points to; else the
  // handbook.
  template <typename Response, typename Request, typename Ask, typename Part>
  absl::StatusOr<Response> AskModel(const Request& request, runtime::CallContext& call, const Ask& ask,
                                    Part part) const;

  const std::unique_ptr<llm::LlmClient> client_;
  const llm::PromptLibrary prompts_;
  const FurnitureIndex furniture_;
  const ModelTools tools_;
};

// For MakeLanguageService: with the model of config.llm, or with one of one's own in its place. Both read the prompts
// once; errors as llm::MakeLlmClient and PromptLibrary::Load.
absl::StatusOr<std::unique_ptr<LanguageHandlers>> MakeModelHandlers(const config::v1::LanguageWorkerConfig& config,
                                                                    const Handbook& handbook,
                                                                    runtime::WorkerContext& worker);
absl::StatusOr<std::unique_ptr<LanguageHandlers>> MakeModelHandlers(std::unique_ptr<llm::LlmClient> model,
                                                                    const config::v1::LanguageWorkerConfig& config,
                                                                    const Handbook& handbook,
                                                                    runtime::WorkerContext& worker);

// Reports what is wrong with the config, but for its runtime.
void CheckLanguageConfig(const config::v1::LanguageWorkerConfig& config, runtime::ConfigChecker& checker);

}  // namespace flair::language
