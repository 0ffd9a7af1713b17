// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/impl/service_type.h>

#include <memory>

#include "absl/status/statusor.h"
#include "flair/config/v1/language_worker_config.pb.h"
#include "worker_runtime/bootstrap/worker_context.h"

namespace flair::language {

// The LanguageService, for flair-language and for programs that host it themselves. Reads the handbook once, errors as
// LoadHandbook. `worker` must outlive it.
absl::StatusOr<std::unique_ptr<grpc::Service>> MakeLanguageService(const config::v1::LanguageWorkerConfig& config,
                                                                   runtime::WorkerContext& worker);

}  // namespace flair::language
