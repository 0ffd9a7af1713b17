// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/server_context.h>
#include <grpcpp/support/server_callback.h>

#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/bootstrap/worker_context.h"
#include "worker_runtime/grpc/rpc_record.h"

namespace flair::runtime {

// Queues `work` on the worker's executor and finishes the call with what it returns: RESOURCE_EXHAUSTED when the queue
// is full, CANCELLED or DEADLINE_EXCEEDED without running it when nobody waits any more. `work` may use the call's
// request and response. Logs one line per call, with `ids`. `worker` must outlive the server.
grpc::ServerUnaryReactor* StartUnary(WorkerContext& worker, std::string_view method, CallIds ids,
                                     grpc::CallbackServerContext& context,
                                     std::function<absl::Status(CallContext&)> work);

namespace internal {
// absl::InfiniteFuture() when the caller set none.
absl::Time DeadlineOf(const grpc::CallbackServerContext& context);
}  // namespace internal

// Answers a unary call of the callback API with a plain handler. `handler` is an object with
//   absl::StatusOr<Response> Handle(const Request&, CallContext&)
// or a callable of that form; it is called from several threads at once and must outlive the server. An answer that
// names its producer gets the worker's build and configuration. Use:
//   grpc::ServerUnaryReactor* Solve(grpc::CallbackServerContext* context, const v1::SolveRequest* request,
//                                   v1::SolveResponse* response) override {
//     return runtime::ServeUnary(worker_, "Solve", context, request, response, solve_handler_);
//   }
template <typename Request, typename Response, typename Handler>
grpc::ServerUnaryReactor* ServeUnary(WorkerContext& worker, std::string_view method,
                                     grpc::CallbackServerContext* context, const Request* request, Response* response,
                                     Handler& handler) {
  return StartUnary(worker, method, internal::CallIdsOf(*request), *context,
                    [&worker, request, response, &handler](CallContext& call) -> absl::Status {
                      absl::StatusOr<Response> answer = [&]() -> absl::StatusOr<Response> {
                        if constexpr (requires { handler.Handle(*request, call); }) {
                          return handler.Handle(*request, call);
                        } else {
                          return handler(*request, call);
                        }
                      }();
                      if (!answer.ok()) return answer.status();
                      *response = *std::move(answer);
                      if constexpr (requires { response->mutable_producer(); }) {
                        if (response->has_producer()) SignProducer(worker, *response->mutable_producer());
                      }
                      return absl::OkStatus();
                    });
}

}  // namespace flair::runtime
