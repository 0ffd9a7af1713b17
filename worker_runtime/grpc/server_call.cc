// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/grpc/server_call.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/logging/log.h"

namespace flair::runtime {
namespace {

// Callers choose their ids; no line is longer for it.
constexpr size_t kLongestId = 200;
constexpr size_t kLongestError = 500;

std::string_view Cut(std::string_view text, size_t limit) { return text.substr(0, limit); }

}  // namespace

RpcRecord::RpcRecord(WorkerContext& worker, std::string_view rpc, CallIds ids)
    : worker_(worker),
      counters_(worker.rpc_metrics.Of(rpc)),
      open_calls_(worker.rpc_metrics.open_calls()),
      rpc_(rpc),
      ids_(std::move(ids)),
      arrival_(worker.clock.Elapsed()) {
  ++*open_calls_;
  counters_.Begin();
}

RpcRecord::~RpcRecord() { --*open_calls_; }

void RpcRecord::Begin() {
  if (wait_ != absl::InfiniteDuration()) return;
  wait_ = worker_.clock.Elapsed() - arrival_;
  counters_.ObserveWait(wait_);
}

absl::Status RpcRecord::Refuse() {
  counters_.Refuse();
  return absl::ResourceExhaustedError(
      fmt::format("{}: the queue is full ({} calls wait); try again later", rpc_, worker_.executor.queued()));
}

void RpcRecord::End(const absl::Status& status, int64_t message_count) {
  const absl::Duration total = worker_.clock.Elapsed() - arrival_;
  counters_.End(status.code(), total);
  const std::string code = absl::StatusCodeToString(status.code());
  const std::string error(Cut(std::string_view(status.message().data(), status.message().size()), kLongestError));
  LogField messages{"messages", {}};
  if (message_count >= 0) messages.value = message_count;
  // Callers that leave are no failure: watchers do when they have seen enough.
  const bool good = status.ok() || absl::IsCancelled(status);
  Log(*worker_.logger, good ? spdlog::level::info : spdlog::level::warn, fmt::format("{} {}", rpc_, code),
      {{"rpc", rpc_},
       {"code", code},
       {"request_id", Cut(ids_.request_id, kLongestId)},
       {"job_id", Cut(ids_.job_id, kLongestId)},
       {"batch_id", Cut(ids_.batch_id, kLongestId)},
       {"duration_ms", absl::ToDoubleMilliseconds(total)},
       {"wait_ms", absl::ToDoubleMilliseconds(std::min(wait_, total))},
       messages,
       {"error", error}});
}

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
