// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/client_context.h>

#include <algorithm>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/grpc/status.h"

namespace flair::runtime {

// Calls `method` of a generated stub and waits. The deadline is the earlier of `deadline` and the caller's own; a
// cancel of the caller cancels the call. Use: UnaryRequest(stub, &v1::OptimizerService::StubInterface::Solve, request,
// call).
template <typename Stub, typename Interface, typename Request, typename Response>
absl::StatusOr<Response> UnaryRequest(
    Stub& stub, grpc::Status (Interface::*method)(grpc::ClientContext*, const Request&, Response*),
    const Request& request, CallContext& call, absl::Time deadline = absl::InfiniteFuture()) {
  grpc::ClientContext context;
  const absl::Time end = std::min(deadline, call.deadline());
  if (end != absl::InfiniteFuture()) context.set_deadline(absl::ToChronoTime(end));
  Response response;
  grpc::Status status;
  {
    OnCancel guard(call.cancellation(), [&context] { context.TryCancel(); });
    status = (stub.*method)(&context, request, &response);
  }
  if (!status.ok()) return FromGrpcStatus(status);
  return response;
}

}  // namespace flair::runtime
