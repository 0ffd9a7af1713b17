// SPDX-License-Identifier: GPL-3.0-or-later
// Calling other programs, and making their errors readable.
#pragma once

#include <grpcpp/client_context.h>
#include <grpcpp/support/status.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::v1 {
class GetWorkerResponse;
}  // namespace flair::v1

namespace flair::runtime {

// Conversions that keep code and message; gRPC's own messages about connections are translated (InPlainWords).
grpc::Status ToGrpcStatus(const absl::Status& status);
absl::Status FromGrpcStatus(const grpc::Status& status);
// The same of the call that had this context; IsOfConnection when no server said so.
absl::Status FromGrpcStatus(const grpc::Status& status, const grpc::ClientContext& context);

// Whether a call failed on the way or in time; otherwise a server answered with the error.
bool IsOfConnection(const absl::Status& status);

// Translates messages of gRPC 1.51 about failed connections and missing answers: what happened, at which address, and
// what to check. Every other message stays as it is.
std::string InPlainWords(std::string_view message);

// Whether a call failed (with a message of InPlainWords) because the server accepted the connection but did not finish
// the handshake in time, for example because it is very busy. The server has not seen the call.
bool HandshakeTimedOut(const absl::Status& status);

// What a server says that has no room for another large message.
inline constexpr char kNoRoom[] = "the server has no room for so large a message at the moment; try again later";

// Whether a server that is there did not take the call, in which nothing was wrong: it may be made again.
bool TurnedAway(const absl::Status& status);

// The package of messages and services that this program speaks; see GetWorkerResponse.protocols.
inline constexpr char kProtocol[] = "flair.v1";

// Why this program cannot talk to a worker, such as "their-optimizer speaks flair.v2, this program flair.v1"; empty if
// it can. A worker that names no protocol speaks ours. Text from the worker is shortened and made printable.
std::string ProtocolFault(const v1::GetWorkerResponse& worker);

// Calls `method` of a generated stub and waits. The deadline is the earlier of `deadline` and the caller's own; if the
// caller cancels, the call is cancelled. Use: UnaryRequest(stub, &v1::OptimizerService::StubInterface::Solve, request,
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
  if (!status.ok()) return FromGrpcStatus(status, context);
  return response;
}

}  // namespace flair::runtime
