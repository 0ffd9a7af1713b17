// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/grpc/unary_call.h"

#include <fmt/format.h>

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
  UnaryCall(WorkerContext& worker, std::string_view method, std::string request_id, absl::Time deadline)
      : worker_(worker),
        method_(method),
        call_(std::move(request_id), deadline, worker.clock),
        arrival_(worker.clock.Elapsed()) {}

  void Start(std::function<absl::Status(CallContext&)> work) {
    if (worker_.executor.TrySubmit([this, work = std::move(work)] { Run(work); })) return;
    End(absl::ResourceExhaustedError(
        fmt::format("{}: the queue is full ({} calls wait); try again later", method_, worker_.executor.queued())));
  }

 private:
  void Run(const std::function<absl::Status(CallContext&)>& work) {
    start_ = worker_.clock.Elapsed();
    absl::Status status = call_.CheckAlive();
    if (status.ok()) status = work(call_);
    End(status);
  }

  void End(const absl::Status& status) {
    const absl::Duration now = worker_.clock.Elapsed();
    worker_.metrics.Count("rpc_count", method_, 1);
    worker_.metrics.Observe("rpc_duration_seconds", method_, absl::ToDoubleSeconds(now - arrival_));
    const double wait_ms = absl::ToDoubleMilliseconds((start_ == absl::ZeroDuration() ? now : start_) - arrival_);
    const double total_ms = absl::ToDoubleMilliseconds(now - arrival_);
    if (status.ok()) {
      worker_.logger->info("{} request_id={} OK {:.1f} ms (waited {:.1f} ms)", method_, call_.request_id(), total_ms,
                           wait_ms);
    } else {
      worker_.logger->warn("{} request_id={} {} {:.1f} ms (waited {:.1f} ms): {}", method_, call_.request_id(),
                           absl::StatusCodeToString(status.code()), total_ms, wait_ms, std::string(status.message()));
    }
    Finish(ToGrpcStatus(status));
  }

  void OnCancel() override { call_.cancellation().Cancel(); }
  void OnDone() override { delete this; }

  WorkerContext& worker_;
  const std::string method_;
  CallContext call_;
  const absl::Duration arrival_;
  absl::Duration start_;
};

}  // namespace

grpc::ServerUnaryReactor* StartUnary(WorkerContext& worker, std::string_view method, std::string request_id,
                                     grpc::CallbackServerContext& context,
                                     std::function<absl::Status(CallContext&)> work) {
  auto* call = new UnaryCall(worker, method, std::move(request_id), internal::DeadlineOf(context));
  call->Start(std::move(work));
  return call;
}

}  // namespace flair::runtime
