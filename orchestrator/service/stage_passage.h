// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "orchestrator/access/access_control.h"
#include "orchestrator/pipeline/stage_clients.h"
#include "worker_runtime/bootstrap/worker_context.h"
#include "worker_runtime/grpc/server.h"

namespace flair::orchestrator {

// The calls of translator, optimizer and renderer that an editor makes between jobs, served by an orchestrator for
// callers whom it lets in: each goes to one of its workers, and nothing is stored. All arguments outlive the services.
std::vector<runtime::NamedService> MakeStagePassages(StageClients& clients, AccessControl& access,
                                                     runtime::WorkerContext& worker);

}  // namespace flair::orchestrator
