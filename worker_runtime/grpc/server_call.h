// SPDX-License-Identifier: GPL-3.0-or-later
// How a service answers calls: who is let in, queue, log line, figures and status of each.
#pragma once

#include <google/protobuf/message.h>
#include <grpcpp/impl/codegen/proto_utils.h>
#include <grpcpp/impl/codegen/server_callback_handlers.h>
#include <grpcpp/impl/codegen/service_type.h>
#include <grpcpp/server_context.h>
#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/server_callback.h>

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/bootstrap/worker_context.h"
#include "worker_runtime/clock/clock.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::runtime {

// Messages between their bytes and what they unfold to.

// Parses `bytes` and lets go of them. INVALID_ARGUMENT for what is no such message, and for a small one that would take
// much memory, such as millions of empty fields: nothing of it is made then.
absl::Status ParseMessage(grpc::ByteBuffer& bytes, google::protobuf::Message& message);

// The same of what anybody may ask: INVALID_ARGUMENT for more than 4 KiB too.
absl::Status ParseShortMessage(grpc::ByteBuffer& bytes, google::protobuf::Message& message);

template <typename Message>
grpc::ByteBuffer BytesOf(const Message& message) {
  grpc::ByteBuffer bytes;
  bool own = false;
  (void)grpc::SerializationTraits<Message>::Serialize(message, &bytes, &own);
  return bytes;
}

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
  RpcRecord(WorkerContext& worker, std::string_view rpc);
  // gRPC is done with it.
  ~RpcRecord();
  RpcRecord(const RpcRecord&) = delete;
  RpcRecord& operator=(const RpcRecord&) = delete;

  // Known from its headers, and from its first message.
  void SetCaller(const std::string& caller) { caller_ = caller; }
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
  std::string caller_;
  CallIds ids_;
  const absl::Duration arrival_;
  absl::Duration wait_ = absl::InfiniteDuration();
};

// What a call does with the bytes that it is sent, until there is an answer. One for each call; its steps never run at
// the same time. `call` and `record` are the call's.
struct CallSteps {
  // Takes the next message; the answer, when that was all.
  std::function<absl::StatusOr<std::optional<grpc::ByteBuffer>>(grpc::ByteBuffer& message, CallContext& call,
                                                                RpcRecord& record)>
      take;
  // The answer, after the last message.
  std::function<absl::StatusOr<grpc::ByteBuffer>(CallContext& call)> finish;
  // Of many messages.
  bool is_stream = false;
};

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

// A service that lets callers in by their headers, before it reads a message. Messages are parsed and answered on the
// worker's executor: RESOURCE_EXHAUSTED when its queue is full, CANCELLED or DEADLINE_EXCEEDED without running the
// handler when nobody waits any more. Logs one line per call. An answer that names its producer gets the worker's build
// and configuration. Use:
//   class Solver final : public runtime::Service {
//     explicit Solver(WorkerContext& worker) : Service(worker, v1::OptimizerService::service_full_name()) {
//       Unary<v1::SolveRequest>("Solve", solve_handler_);
//     }
class Service : public grpc::Service {
 protected:
  // `worker` outlives the server.
  Service(WorkerContext& worker, std::string name) : worker_(worker), name_(std::move(name)) {}

  // Answers a call by a handler: an object that outlives the server, with
  //   absl::StatusOr<Response> Handle(const Request&, CallContext&)
  // or a callable of that form. It is called from several threads at once.
  template <typename Request, typename Handler>
  void Unary(const std::string& rpc, Handler&& handler) {
    if constexpr (requires(const Request& request, CallContext& call) { handler.Handle(request, call); }) {
      AddUnary<Request>(
          rpc, [&handler](const Request& request, CallContext& call) { return handler.Handle(request, call); });
    } else {
      AddUnary<Request>(rpc, std::forward<Handler>(handler));
    }
  }

  // Answers a call of many messages. `make` returns a std::unique_ptr to an object of this call alone with
  //   absl::Status Take(const Request&, CallContext&)         for every message, in order
  //   absl::StatusOr<Response> Finish(CallContext&)           after the last
  // Each step waits in the worker's queue like a unary call, and the next message is read after the step: a slow caller
  // holds no thread, a fast one no memory. The first error ends the call.
  template <typename Request, typename Make>
  void ClientStream(const std::string& rpc, Make make) {
    AddSteps(rpc, [this, make]() -> CallSteps {
      // Shared by the steps, which std::function copies.
      const std::shared_ptr taker = make();
      return {.take = [taker](grpc::ByteBuffer& bytes, CallContext& call,
                              RpcRecord& record) -> absl::StatusOr<std::optional<grpc::ByteBuffer>> {
                Request request;
                RETURN_IF_ERROR(ParseMessage(bytes, request));
                if (CallIds ids = CallIdsOf(request); !ids.request_id.empty()) record.SetIds(std::move(ids));
                RETURN_IF_ERROR(taker->Take(request, call));
                return std::nullopt;
              },
              .finish = [this, taker](CallContext& call) { return Answer(taker->Finish(call)); },
              .is_stream = true};
    });
  }

  // Answers a call by a reactor of its own, which is made when the headers have come.
  template <typename Response>
  void ServerStream(
      const std::string& rpc,
      std::function<grpc::ServerBidiReactor<grpc::ByteBuffer, Response>*(grpc::CallbackServerContext*)> make) {
    AddMethod(rpc, new grpc::internal::CallbackBidiHandler<grpc::ByteBuffer, Response>(std::move(make)));
  }

  // Whether the call may go on, and whose it is (call.set_caller). As it is: whose certificate has one of the names
  // that the worker believes, where it believes some (TlsConfig.client_names).
  virtual absl::Status Admit(grpc::CallbackServerContext& context, CallContext& call);

  WorkerContext& worker_;

 private:
  template <typename Request, typename Function>
  void AddUnary(const std::string& rpc, Function function) {
    AddSteps(rpc, [this, function]() -> CallSteps {
      return {.take = [this, &function](grpc::ByteBuffer& bytes, CallContext& call,
                                        RpcRecord& record) -> absl::StatusOr<std::optional<grpc::ByteBuffer>> {
                Request request;
                RETURN_IF_ERROR(ParseMessage(bytes, request));
                CallIds ids = CallIdsOf(request);
                call.set_request_id(ids.request_id);
                record.SetIds(std::move(ids));
                return Answer(function(request, call));
              },
              .finish = [](CallContext&) { return absl::InvalidArgumentError("the call has no request"); }};
    });
  }

  template <typename Response>
  absl::StatusOr<grpc::ByteBuffer> Answer(absl::StatusOr<Response> response) {
    RETURN_IF_ERROR(response.status());
    if constexpr (requires { response->mutable_producer(); }) {
      if (response->has_producer()) SignProducer(worker_, *response->mutable_producer());
    }
    return BytesOf(*response);
  }

  void AddSteps(const std::string& rpc, std::function<CallSteps()> make);
  void AddMethod(const std::string& rpc, grpc::internal::MethodHandler* handler);

  const std::string name_;
  // gRPC keeps no copies.
  std::deque<std::string> paths_;
};

// absl::InfiniteFuture() when the caller set none.
absl::Time DeadlineOf(const grpc::CallbackServerContext& context);

// A handler for Service::Unary that tells `observe(request, response, duration)` of every good answer of another
// handler, for counting. The arguments outlive it; `observe` is called from several threads at once.
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
