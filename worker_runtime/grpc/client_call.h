// SPDX-License-Identifier: GPL-3.0-or-later
// How another program is called, and what is made of its errors.
#pragma once

#include <grpcpp/client_context.h>
#include <grpcpp/support/status.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::v1 {
class GetWorkerResponse;
}  // namespace flair::v1

namespace flair::runtime {

// The same code and message on the other side, but what gRPC itself says of connections in plain words (InPlainWords).
grpc::Status ToGrpcStatus(const absl::Status& status);
absl::Status FromGrpcStatus(const grpc::Status& status);

// What gRPC 1.51 says of a connection that did not come about, or of an answer that did not come, as a person would:
// what happened, at which address, and what to look at. Every other message stays as it is.
std::string InPlainWords(std::string_view message);

// Whether a call ended, as told in plain words, because the server took the connection and did not say hello in time,
// as one that is very busy may not: it has not heard of the call.
bool SaidNoHello(const absl::Status& status);

// The package of messages and services that this program speaks; see GetWorkerResponse.protocols.
inline constexpr char kProtocol[] = "flair.v1";

// What keeps this program from talking to a worker, such as "their-optimizer speaks flair.v2, this program flair.v1";
// empty when nothing does. A worker that names no protocol speaks ours. What it says of itself is cut short and
// printable.
std::string ProtocolFault(const v1::GetWorkerResponse& worker);

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
