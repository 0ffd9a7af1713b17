// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/impl/service_type.h>

#include <functional>
#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "flair/config/v1/translator_worker_config.pb.h"
#include "flair/v1/translator_service.pb.h"
#include "translator_worker/catalog/catalog_source.h"
#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/bootstrap/worker_context.h"

namespace flair::translator {

// What translates in the place of the grammar; see model/model_translator.h. Thread-safe.
class Translator {
 public:
  virtual ~Translator() = default;

  // The graph and the record of calls of a valid request whose catalogue is set.
  virtual absl::StatusOr<v1::TranslateResponse> Translate(const v1::TranslateRequest& request,
                                                          runtime::CallContext& call) const = 0;

  // Who answers, for producers; and all that decides the answers, for the keys of results.
  virtual std::string model() const = 0;
  virtual std::string version() const = 0;
};

using ModelTranslatorMaker = std::function<absl::StatusOr<std::unique_ptr<const Translator>>(
    const config::v1::TranslatorWorkerConfig&, runtime::WorkerContext&)>;

// The TranslatorService, for flair-translator and for programs that host it themselves. `worker` must outlive it.
// Without an optimizer_address every request must bring the catalogue. When the config has an llm, what `with_model`
// makes translates, and INVALID_ARGUMENT when it is null; errors as `with_model`.
absl::StatusOr<std::unique_ptr<grpc::Service>> MakeTranslatorService(const config::v1::TranslatorWorkerConfig& config,
                                                                     runtime::WorkerContext& worker,
                                                                     const ModelTranslatorMaker& with_model = nullptr);

// The same with a source and a model of one's own; without a model the grammar translates.
std::unique_ptr<grpc::Service> MakeTranslatorService(std::unique_ptr<CatalogSource> source,
                                                     std::unique_ptr<const Translator> model,
                                                     runtime::WorkerContext& worker);

}  // namespace flair::translator
