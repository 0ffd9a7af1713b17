// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/impl/service_type.h>

#include <memory>

#include "session/documents/documents.h"
#include "worker_runtime/bootstrap/worker_context.h"

namespace flair::studio {

// The StudioService on these documents. `documents` and `worker` must outlive it; watchers are ended by the server's
// stop.
std::unique_ptr<grpc::Service> MakeStudioService(session::Documents& documents, runtime::WorkerContext& worker);

}  // namespace flair::studio
