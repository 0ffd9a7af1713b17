// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/impl/service_type.h>

#include <memory>

#include "absl/status/statusor.h"
#include "flair/config/v1/translator_worker_config.pb.h"
#include "translator_worker/catalog/catalog_source.h"
#include "worker_runtime/bootstrap/worker_context.h"

namespace flair::translator {

// The TranslatorService, for flair-translator and for programs that host it themselves. `worker` must outlive it.
// Without an optimizer_address every request must bring the catalogue.
absl::StatusOr<std::unique_ptr<grpc::Service>> MakeTranslatorService(const config::v1::TranslatorWorkerConfig& config,
                                                                     runtime::WorkerContext& worker);

// The same with a source of one's own, such as a RemoteCatalogSource over an in-process channel.
std::unique_ptr<grpc::Service> MakeTranslatorService(std::unique_ptr<CatalogSource> source,
                                                     runtime::WorkerContext& worker);

}  // namespace flair::translator
