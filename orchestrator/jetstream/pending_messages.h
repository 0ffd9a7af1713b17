// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nats/nats.h>

#include <cstdint>
#include <functional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/synchronization/mutex.h"
#include "absl/time/time.h"
#include "orchestrator/jetstream/connection.h"

namespace flair::orchestrator {

// Messages that were sent and not yet acknowledged. Thread-safe.
class PendingMessages {
 public:
  using Result = absl::StatusOr<uint64_t>;
  // Messages of one call.
  struct Call {
    std::vector<natsMsg*> sent;
    int64_t awaited = 0;
  };

  // `to_status` says what a natsStatus, an error code and their text are.
  using ToStatus = std::function<absl::Status(int nats_status, int error_code, const char* text)>;
  explicit PendingMessages(ToStatus to_status) : to_status_(std::move(to_status)) {}

  // The acknowledgement of the message comes to `result`, until it is forgotten or awaited no longer.
  void Add(Call& call, natsMsg* message, Result* result) {
    const absl::MutexLock lock(&mutex_);
    waiting_[message] = {&call, result};
    call.sent.push_back(message);
    ++call.awaited;
  }
  void ForgetLast(Call& call) {
    const absl::MutexLock lock(&mutex_);
    waiting_.erase(call.sent.back());
    call.sent.pop_back();
    --call.awaited;
  }
  // Until all of a call have come, no longer than `limit`; the others keep the results that they have.
  void Await(Call& call, absl::Duration limit) {
    const absl::MutexLock lock(&mutex_);
    mutex_.AwaitWithTimeout(absl::Condition(
                                +[](int64_t* awaited) { return *awaited == 0; }, &call.awaited),
                            limit);
    for (natsMsg* message : call.sent) waiting_.erase(message);
  }
  static void OnAck(jsCtx* /*context*/, natsMsg* message, jsPubAck* ack, jsPubAckErr* error, void* pending) {
    const NatsMessagePtr made(message);
    static_cast<PendingMessages*>(pending)->Came(message, ack, error);
  }

 private:
  void Came(natsMsg* message, const jsPubAck* ack, const jsPubAckErr* error) {
    const absl::MutexLock lock(&mutex_);
    const auto found = waiting_.find(message);
    if (found == waiting_.end()) return;
    const auto [call, result] = found->second;
    *result = ack != nullptr ? Result(ack->Sequence) : Result(to_status_(error->Err, error->ErrCode, error->ErrText));
    --call->awaited;
    waiting_.erase(found);
  }

  const ToStatus to_status_;
  absl::Mutex mutex_;
  std::unordered_map<natsMsg*, std::pair<Call*, Result*>> waiting_;
};

}  // namespace flair::orchestrator
