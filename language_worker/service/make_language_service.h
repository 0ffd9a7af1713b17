// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/impl/service_type.h>

#include <functional>
#include <memory>

#include "absl/status/statusor.h"
#include "flair/config/v1/language_worker_config.pb.h"
#include "language_worker/service/language_handlers.h"
#include "worker_runtime/bootstrap/worker_context.h"

namespace flair::language {

// Makes handlers that ask the config's language model, and adds to the worker's revision what decides their answers;
// see model/model_handlers.h.
using ModelHandlersMaker = std::function<absl::StatusOr<std::unique_ptr<LanguageHandlers>>(
    const config::v1::LanguageWorkerConfig&, const Handbook&, runtime::WorkerContext&)>;

// The LanguageService, for flair-language and for programs that host it themselves. The handbook answers; when the
// config has an llm, the handlers that `with_model` makes, and INVALID_ARGUMENT when it is null. Reads the handbook
// once; errors as LoadHandbook and `with_model`. `worker` must outlive it.
absl::StatusOr<std::unique_ptr<grpc::Service>> MakeLanguageService(const config::v1::LanguageWorkerConfig& config,
                                                                   runtime::WorkerContext& worker,
                                                                   const ModelHandlersMaker& with_model = nullptr);

}  // namespace flair::language
