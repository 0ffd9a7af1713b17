// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/impl/service_type.h>

#include <memory>

#include "absl/status/statusor.h"
#include "flair/config/v1/translator_worker_config.pb.h"
#include "translator_worker/catalog/catalog_source.h"
#include "translator_worker/model/model_translator.h"
#include "worker_runtime/bootstrap/worker_context.h"
#include "worker_runtime/config/config_reader.h"

namespace flair::translator {

// The TranslatorService, for flair-translator and for programs that host it themselves. `worker` must outlive it.
// Without an optimizer_address every request must bring the catalogue. With an llm a model translates; errors as
// llm::MakeLlmClient and PromptLibrary::Load.
absl::StatusOr<std::unique_ptr<grpc::Service>> MakeTranslatorService(const config::v1::TranslatorWorkerConfig& config,
                                                                     runtime::WorkerContext& worker);

// The same with a source and a model of one's own; without a model the grammar translates.
std::unique_ptr<grpc::Service> MakeTranslatorService(std::unique_ptr<CatalogSource> source,
                                                     std::unique_ptr<const ModelTranslator> model,
                                                     runtime::WorkerContext& worker);

// Reports what is wrong with the config, but for its runtime.
void CheckTranslatorConfig(const config::v1::TranslatorWorkerConfig& config, runtime::ConfigChecker& checker);

}  // namespace flair::translator
