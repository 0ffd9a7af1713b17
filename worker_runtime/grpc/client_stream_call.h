// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/server_context.h>
#include <grpcpp/support/server_callback.h>

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/bootstrap/worker_context.h"
#include "worker_runtime/grpc/rpc_record.h"

namespace flair::runtime {

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
                 absl::StatusOr<Response> answer = shared->Finish(of);
                 if (!answer.ok()) return answer.status();
                 *response = *std::move(answer);
                 if constexpr (requires { response->mutable_producer(); }) {
                   if (response->has_producer()) response->mutable_producer()->set_build(worker.build);
                 }
                 return absl::OkStatus();
               }});
  return call;
}

}  // namespace flair::runtime
