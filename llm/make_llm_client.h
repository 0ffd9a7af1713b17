// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "absl/status/statusor.h"
#include "flair/config/v1/llm_config.pb.h"
#include "llm/client/llm_client.h"
#include "worker_runtime/bootstrap/worker_context.h"

namespace flair::llm {

// The model of a config, with all its wrappers. Reads keys from the environment and from files now, so that a missing
// one is known at once: INVALID_ARGUMENT names the field; FAILED_PRECONDITION for a key, a certificate file or a folder
// that cannot be used; NOT_FOUND when there is no recording to replay. `worker` must outlive it.
absl::StatusOr<std::unique_ptr<LlmClient>> MakeLlmClient(const config::v1::LlmConfig& config,
                                                         runtime::WorkerContext& worker);

}  // namespace flair::llm
