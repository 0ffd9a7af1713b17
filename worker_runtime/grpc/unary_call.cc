// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/grpc/unary_call.h"

#include <chrono>

#include "worker_runtime/grpc/status.h"

namespace flair::runtime {

absl::Time internal::DeadlineOf(const grpc::CallbackServerContext& context) {
  const std::chrono::system_clock::time_point deadline = context.deadline();
  if (deadline == std::chrono::system_clock::time_point::max()) return absl::InfiniteFuture();
  return absl::FromChrono(deadline);
}

namespace {

// One call from arrival to answer. Deletes itself when gRPC is done with it, which is never before Finish.
class UnaryCall final : public grpc::ServerUnaryReactor {
 public:
  UnaryCall(WorkerContext& worker, std::string_view method, CallIds ids, absl::Time deadline)
      : worker_(worker), call_(ids.request_id, deadline, worker.clock), record_(worker, method, std::move(ids)) {}

  void Start(std::function<absl::Status(CallContext&)> work) {
    if (worker_.executor.TrySubmit([this, work = std::move(work)] { Run(work); })) return;
    End(record_.Refuse());
  }

 private:
  void Run(const std::function<absl::Status(CallContext&)>& work) {
    record_.Begin();
    absl::Status status = call_.CheckAlive();
    if (status.ok()) status = work(call_);
    End(status);
  }

  void End(const absl::Status& status) {
    record_.End(status);
    Finish(ToGrpcStatus(status));
  }

  void OnCancel() override { call_.cancellation().Cancel(); }
  void OnDone() override { delete this; }

  WorkerContext& worker_;
  CallContext call_;
  RpcRecord record_;
};

}  // namespace

grpc::ServerUnaryReactor* StartUnary(WorkerContext& worker, std::string_view method, CallIds ids,
                                     grpc::CallbackServerContext& context,
                                     std::function<absl::Status(CallContext&)> work) {
  auto* call = new UnaryCall(worker, method, std::move(ids), internal::DeadlineOf(context));
  call->Start(std::move(work));
  return call;
}

}  // namespace flair::runtime
