// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/grpc/client_stream_call.h"

#include "worker_runtime/grpc/status.h"
#include "worker_runtime/grpc/unary_call.h"

namespace flair::runtime::internal {

StreamState::StreamState(WorkerContext& worker, std::string_view method, const grpc::CallbackServerContext& context)
    : worker_(worker), call_("", DeadlineOf(context), worker.clock), record_(worker, method, {}) {}

void StreamState::Submit(const std::function<absl::Status(CallContext&)>& step,
                         std::function<void(absl::Status)> next) {
  // By reference, so that nothing of the call outlives it in the executor's hands.
  const auto run = [this, &step, next] {
    record_.Begin();
    absl::Status status = call_.CheckAlive();
    if (status.ok()) status = step(call_);
    next(status);
  };
  if (worker_.executor.TrySubmit(run)) return;
  next(record_.Refuse());
}

grpc::Status StreamState::End(const absl::Status& status) {
  record_.End(status, message_count_);
  return ToGrpcStatus(status);
}

}  // namespace flair::runtime::internal
