// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/grpc/rpc_record.h"

#include <fmt/format.h>

#include <algorithm>

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
  // Callers who leave are nobody's fault: watchers do when they have seen enough.
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

}  // namespace flair::runtime
