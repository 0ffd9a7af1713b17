// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "absl/time/time.h"
#include "worker_runtime/bootstrap/worker_context.h"

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

}  // namespace flair::runtime
