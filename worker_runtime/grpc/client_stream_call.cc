// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/grpc/client_stream_call.h"

#include <fmt/format.h>

#include "worker_runtime/grpc/status.h"
#include "worker_runtime/grpc/unary_call.h"

namespace flair::runtime::internal {

StreamState::StreamState(WorkerContext& worker, std::string_view method, const grpc::CallbackServerContext& context)
    : worker_(worker),
      method_(method),
      call_("", DeadlineOf(context), worker.clock),
      arrival_(worker.clock.Elapsed()) {}

void StreamState::Submit(const std::function<absl::Status(CallContext&)>& step,
                         std::function<void(absl::Status)> next) {
  // By reference, so that nothing of the call outlives it in the executor's hands.
  const auto run = [this, &step, next] {
    absl::Status status = call_.CheckAlive();
    if (status.ok()) status = step(call_);
    next(status);
  };
  if (worker_.executor.TrySubmit(run)) return;
  next(absl::ResourceExhaustedError(
      fmt::format("{}: the queue is full ({} calls wait); try again later", method_, worker_.executor.queued())));
}

grpc::Status StreamState::End(const absl::Status& status) {
  const absl::Duration taken = worker_.clock.Elapsed() - arrival_;
  worker_.metrics.Count("rpc_count", method_, 1);
  worker_.metrics.Observe("rpc_duration_seconds", method_, absl::ToDoubleSeconds(taken));
  const double total_ms = absl::ToDoubleMilliseconds(taken);
  if (status.ok()) {
    worker_.logger->info("{} OK {} messages {:.1f} ms", method_, message_count_, total_ms);
  } else {
    worker_.logger->warn("{} {} {} messages {:.1f} ms: {}", method_, absl::StatusCodeToString(status.code()),
                         message_count_, total_ms, std::string(status.message()));
  }
  return ToGrpcStatus(status);
}

}  // namespace flair::runtime::internal
