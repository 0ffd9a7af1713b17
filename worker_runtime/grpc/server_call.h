// SPDX-License-Identifier: GPL-3.0-or-later
// How a service answers calls: queue, log line, figures and status of each.
#pragma once

#include <grpcpp/server_context.h>
#include <grpcpp/support/server_callback.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/bootstrap/worker_context.h"
#include "worker_runtime/clock/clock.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::runtime {

// What a call is about: the keys under which its log line is found. Any may be empty.
struct CallIds {
  std::string request_id;
  std::string job_id;
  std::string batch_id;
};

// Counts one call and logs one line of it. Lives as long as the call: a server that stops waits for those that are
// left. `worker` outlives it; `rpc` is a name from our own code. Not thread-safe.
class RpcRecord {
 public:
  // The call has arrived.
  RpcRecord(WorkerContext& worker, std::string_view rpc, CallIds ids);
  // gRPC is done with it.
  ~RpcRecord();
  RpcRecord(const RpcRecord&) = delete;
  RpcRecord& operator=(const RpcRecord&) = delete;

  // Known only now, as with a stream's first message.
  void SetIds(CallIds ids) { ids_ = std::move(ids); }

  // A thread works on it; the first time counts.
  void Begin();

  // What a call is told that came while too many waited, counted.
  absl::Status Refuse();

  // The answer is on its way. `message_count` of streams; -1 for other calls.
  void End(const absl::Status& status, int64_t message_count = -1);

 private:
  WorkerContext& worker_;
  RpcCounters& counters_;
  const std::shared_ptr<std::atomic<int>> open_calls_;
  const std::string rpc_;
  CallIds ids_;
  const absl::Duration arrival_;
  absl::Duration wait_ = absl::InfiniteDuration();
};

namespace internal {

// The ids under which a request is known: its own, which holds that of its job where it has one, or of what it is
// about.
template <typename Request>
CallIds CallIdsOf(const Request& request) {
  CallIds ids;
  if constexpr (requires { request.request_id(); }) {
    ids.request_id = request.request_id();
  } else if constexpr (requires { request.options().request_id(); }) {
    ids.request_id = request.options().request_id();
  } else {
    if constexpr (requires { request.job_id(); }) ids.job_id = request.job_id();
    if constexpr (requires { request.batch_id(); }) ids.batch_id = request.batch_id();
  }
  return ids;
}

}  // namespace internal

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
                      if constexpr (requires { handler.Handle(*request, call); }) {
                        ASSIGN_OR_RETURN(*response, handler.Handle(*request, call));
                      } else {
                        ASSIGN_OR_RETURN(*response, handler(*request, call));
                      }
                      if constexpr (requires { response->mutable_producer(); }) {
                        if (response->has_producer()) SignProducer(worker, *response->mutable_producer());
                      }
                      return absl::OkStatus();
                    });
}

// What a call of many messages and one answer consists of, without its message types. One for each call, deleted with
// it; its steps never run at the same time.
struct ClientStreamSteps {
  // Takes the message that was read last. `call` as for a unary call.
  std::function<absl::Status(CallContext& call)> take;
  // Writes the answer, after the last message.
  std::function<absl::Status(CallContext& call)> finish;
};

namespace internal {

// Queue, log line and status of a stream; gRPC calls it through ClientStreamCall.
class StreamState {
 public:
  StreamState(WorkerContext& worker, std::string_view method, const grpc::CallbackServerContext& context);
  // Runs `step` on the executor and tells `next` how it ended; RESOURCE_EXHAUSTED at once when the queue is full.
  // `step` must live until then; `next` may delete this object.
  void Submit(const std::function<absl::Status(CallContext&)>& step, std::function<void(absl::Status)> next);
  // Counts and logs the call, and returns what gRPC is to be told.
  grpc::Status End(const absl::Status& status);
  CallContext& call() { return call_; }
  // The first message tells what the call is about.
  void CountMessage(CallIds ids) {
    if (message_count_++ == 0) record_.SetIds(std::move(ids));
  }

 private:
  WorkerContext& worker_;
  CallContext call_;
  RpcRecord record_;
  int message_count_ = 0;
};

// One call from arrival to answer. Deletes itself when gRPC is done with it.
template <typename Request>
class ClientStreamCall final : public grpc::ServerReadReactor<Request> {
 public:
  ClientStreamCall(WorkerContext& worker, std::string_view method, const grpc::CallbackServerContext& context)
      : state_(worker, method, context) {}

  const Request& message() const { return message_; }
  void Start(ClientStreamSteps steps) {
    steps_ = std::move(steps);
    this->StartRead(&message_);
  }

 private:
  void OnReadDone(bool has_message) override {
    if (!has_message && state_.call().cancellation().cancelled()) {
      End(state_.call().CheckAlive());
    } else if (has_message) {
      state_.CountMessage(CallIdsOf(message_));
      // The next message is read when this one has been taken, so that one is held at a time.
      state_.Submit(steps_.take, [this](const absl::Status& status) {
        if (status.ok()) {
          this->StartRead(&message_);
        } else {
          End(status);
        }
      });
    } else {
      state_.Submit(steps_.finish, [this](const absl::Status& status) { End(status); });
    }
  }
  void End(const absl::Status& status) { this->Finish(state_.End(status)); }
  void OnCancel() override { state_.call().cancellation().Cancel(); }
  void OnDone() override { delete this; }

  StreamState state_;
  Request message_;
  ClientStreamSteps steps_;
};

}  // namespace internal

// Answers a client-streaming call of the callback API. `taker` is an object of this call alone with
//   absl::Status Take(const Request&, CallContext&)         for every message, in order
//   absl::StatusOr<Response> Finish(CallContext&)           after the last
// Each step waits in the worker's queue like a unary call, and the next message is read after the step: a slow caller
// holds no thread, a fast one no memory. The first error ends the call. An answer that names its producer gets the
// worker's build. `worker` must outlive the server.
template <typename Request, typename Response, typename Taker>
grpc::ServerReadReactor<Request>* ServeClientStream(WorkerContext& worker, std::string_view method,
                                                    grpc::CallbackServerContext* context, Response* response,
                                                    std::unique_ptr<Taker> taker) {
  auto* call = new internal::ClientStreamCall<Request>(worker, method, *context);
  // Shared by the two steps, which std::function copies.
  const std::shared_ptr<Taker> shared = std::move(taker);
  call->Start({.take = [call, shared](CallContext& of) { return shared->Take(call->message(), of); },
               .finish = [&worker, shared, response](CallContext& of) -> absl::Status {
                 ASSIGN_OR_RETURN(*response, shared->Finish(of));
                 if constexpr (requires { response->mutable_producer(); }) {
                   if (response->has_producer()) response->mutable_producer()->set_build(worker.build);
                 }
                 return absl::OkStatus();
               }});
  return call;
}

// A handler for ServeUnary that tells `observe(request, response, duration)` of every good answer of another handler,
// for counting. The arguments outlive it; `observe` is called from several threads at once.
template <typename Handler, typename Observe>
class ObservedHandler {
 public:
  ObservedHandler(Handler& inner, const Clock& clock, Observe observe)
      : inner_(inner), clock_(clock), observe_(std::forward<Observe>(observe)) {}

  template <typename Request>
  auto Handle(const Request& request, CallContext& call) {
    const absl::Duration start = clock_.Elapsed();
    auto response = inner_.Handle(request, call);
    if (response.ok()) observe_(request, *response, clock_.Elapsed() - start);
    return response;
  }

 private:
  Handler& inner_;
  const Clock& clock_;
  Observe observe_;
};

}  // namespace flair::runtime
