// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/client_context.h>
#include <grpcpp/completion_queue.h>
#include <grpcpp/support/async_unary_call.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <memory>
#include <mutex>
#include <set>
#include <utility>

#include "absl/status/status.h"
#include "absl/time/time.h"
#include "orchestrator/pipeline/stage_clients.h"
#include "orchestrator/workers/verdict.h"
#include "orchestrator/workers/workers_of_stage.h"
#include "worker_runtime/grpc/client_call.h"

namespace flair::orchestrator {

// One request to one worker or, when that one takes its time, to a second one as well: the first answer counts, and the
// other call is cancelled. All calls of stages are idempotent by request id. Waits in the calling thread, which alone
// drives the calls. Used once.
template <typename Service, typename Request, typename Response>
class WorkerCall {
 public:
  using Method = std::unique_ptr<grpc::ClientAsyncResponseReaderInterface<Response>> (Service::StubInterface::*)(
      grpc::ClientContext*, const Request&, grpc::CompletionQueue*);

  // How the call to one worker ended, or goes on.
  struct Attempt {
    Place place;
    std::shared_ptr<Connection> connection;
    grpc::ClientContext context;
    std::unique_ptr<grpc::ClientAsyncResponseReaderInterface<Response>> reader;
    Response response;
    grpc::Status grpc_status;
    // Of an attempt that has ended.
    absl::Status status;
  };

  WorkerCall(WorkersOfStage& workers, Method method, const Request& request, runtime::CallContext& call)
      : workers_(workers), method_(method), request_(request), call_(call) {}

  // Calls the worker of `place` and, after `hedge_after`, one that is neither that nor `tried`. Gives back all places.
  // Returns the attempt that counts.
  Attempt& Run(const Place& place, const std::set<WorkerId>& tried, absl::Duration hedge_after) {
    std::set<WorkerId> taken = tried;
    taken.insert(place.worker);
    const auto cancel = [this] { CancelAll(); };
    runtime::OnCancel guard(call_.cancellation(), cancel);
    Begin(place);
    Attempt* winner = nullptr;
    while (running_ > 0) {
      Attempt* ended = Next(attempts_.size() == 1 && winner == nullptr ? hedge_after : absl::InfiniteDuration());
      if (ended == nullptr) {
        if (std::optional<Place> second = workers_.pool().TryTake(taken)) Begin(*second);
      } else if (winner == nullptr && VerdictOf(ended->status) == Verdict::kGood) {
        winner = ended;
        // To cancel what has ended is work too.
        if (running_ > 0) CancelAll();
      }
    }
    events_.Shutdown();
    void* tag = nullptr;
    for (bool ok = false; events_.Next(&tag, &ok);) {
    }
    return winner == nullptr ? attempts_.front() : *winner;
  }

  // One or two, the first first.
  const std::deque<Attempt>& attempts() const { return attempts_; }

 private:
  void Begin(const Place& place) {
    std::lock_guard lock(mutex_);
    Attempt& attempt = attempts_.emplace_back();
    attempt.place = place;
    attempt.connection = workers_.ConnectionTo(place.worker);
    if (attempt.connection == nullptr) {
      End(attempt, absl::UnavailableError("it has gone"));
      return;
    }
    if (call_.deadline() != absl::InfiniteFuture()) attempt.context.set_deadline(absl::ToChronoTime(call_.deadline()));
    typename Service::StubInterface& stub = attempt.connection->template StubOf<Service>();
    attempt.reader = (stub.*method_)(&attempt.context, request_, &events_);
    attempt.reader->StartCall();
    attempt.reader->Finish(&attempt.response, &attempt.grpc_status, &attempt);
    ++running_;
    if (cancelled_) attempt.context.TryCancel();
  }

  // The attempt that ended next; null when none did within `patience`.
  Attempt* Next(absl::Duration patience) {
    void* tag = nullptr;
    bool ok = false;
    if (patience == absl::InfiniteDuration()) {
      events_.Next(&tag, &ok);
    } else if (events_.AsyncNext(&tag, &ok, std::chrono::system_clock::now() + absl::ToChronoNanoseconds(patience)) ==
               grpc::CompletionQueue::TIMEOUT) {
      return nullptr;
    }
    --running_;
    Attempt& attempt = *static_cast<Attempt*>(tag);
    End(attempt, runtime::FromGrpcStatus(attempt.grpc_status));
    return &attempt;
  }

  void End(Attempt& attempt, absl::Status status) {
    attempt.status = std::move(status);
    workers_.pool().End(attempt.place, VerdictOf(attempt.status));
  }

  void CancelAll() {
    std::lock_guard lock(mutex_);
    cancelled_ = true;
    for (Attempt& attempt : attempts_) attempt.context.TryCancel();
  }

  WorkersOfStage& workers_;
  const Method method_;
  const Request& request_;
  runtime::CallContext& call_;
  grpc::CompletionQueue events_;
  int running_ = 0;
  // Guards the list against CancelAll from other threads.
  std::mutex mutex_;
  bool cancelled_ = false;
  // Stays where it is as it grows.
  std::deque<Attempt> attempts_;
};

}  // namespace flair::orchestrator
