// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/impl/service_type.h>

#include <memory>

#include "absl/status/statusor.h"
#include "flair/config/v1/language_worker_config.pb.h"
#include "llm/client/llm_client.h"
#include "worker_runtime/bootstrap/worker_context.h"
#include "worker_runtime/config/config_reader.h"

namespace flair::language {

// The LanguageService, for flair-language and for programs that host it themselves. With an llm the model answers, else
// the handbook. Reads handbook and prompts once; errors as LoadHandbook, llm::MakeLlmClient and PromptLibrary::Load.
// `worker` must outlive it.
absl::StatusOr<std::unique_ptr<grpc::Service>> MakeLanguageService(const config::v1::LanguageWorkerConfig& config,
                                                                   runtime::WorkerContext& worker);

// The same with a model of one's own, which takes the place of the configured one.
absl::StatusOr<std::unique_ptr<grpc::Service>> MakeLanguageService(const config::v1::LanguageWorkerConfig& config,
                                                                   std::unique_ptr<llm::LlmClient> model,
                                                                   runtime::WorkerContext& worker);

// Reports what is wrong with the config, but for its runtime.
void CheckLanguageConfig(const config::v1::LanguageWorkerConfig& config, runtime::ConfigChecker& checker);

}  // namespace flair::language
