// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstdint>
#include <list>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "orchestrator/workers/verdict.h"
#include "orchestrator/workers/worker_roster.h"
#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/clock/clock.h"

namespace flair::orchestrator {

// The workers of one stage, and the calls that want one: who goes to which, and who waits. Calls go to the best worker
// (WorkerRoster) and, when all are full, wait in line. Knows nothing of gRPC. Thread-safe.
class WorkerPool {
 public:
  WorkerPool(WorkerPoolOptions options, const runtime::Clock& clock) : clock_(clock), roster_(std::move(options)) {}

  // ---- Who is there

  // A worker that is about to be reached.
  WorkerId Add(const std::string& address);
  // It is there, as that revision (StageClients::Revision); anew, when it was not before.
  void SetReady(WorkerId id, std::optional<std::string> revision);
  // It was lost and may be back in a moment.
  void SetConnecting(WorkerId id);
  // It is not there, or of no use. UNAVAILABLE, or how calls are to end if all are like that.
  void SetGone(WorkerId id, absl::Status reason);
  void Remove(WorkerId id);
  // All that are to be known now are added; or why not. Until then calls wait.
  void SetFound(absl::Status lookup);

  // ---- Calls

  // A place at the best worker but those `tried` already; waits in line while all are full, and while the broken ones
  // may not be tried. UNAVAILABLE when none is there; CANCELLED or DEADLINE_EXCEEDED by `call`.
  absl::StatusOr<Place> Take(const std::set<WorkerId>& tried, runtime::CallContext& call);
  // The same without waiting; nothing when no worker has room.
  std::optional<Place> TryTake(const std::set<WorkerId>& tried);
  void End(const Place& place, Verdict verdict);
  // A call that ended as kGood had a bad answer.
  void ReportBadAnswer(const Place& place);

  // That of the worker that would take the next call, full or not. Waits and fails as Take.
  absl::StatusOr<std::optional<std::string>> Revision(runtime::CallContext& call);

  // Calls in line.
  int waiting() const;

  // All workers, by address.
  std::vector<v1::WorkerStatus> Status() const;

 private:
  struct Waiter {
    const std::set<WorkerId>& tried;
    // Only wants to know who would take it.
    bool only_asks;
    // Openings of circuits when it found all workers broken.
    std::optional<int64_t> openings = {};
    std::optional<Place> place = {};
    absl::Status end = {};
    std::condition_variable wake = {};
  };
  absl::StatusOr<Place> WaitInLine(const std::set<WorkerId>& tried, bool only_asks, runtime::CallContext& call);
  // All below: with mutex_ held.
  void ServeLine();
  void Serve(Waiter& waiter, absl::Duration now, std::optional<WorkerRoster::Wait>& untried);

  const runtime::Clock& clock_;
  mutable std::mutex mutex_;
  WorkerRoster roster_;
  std::list<Waiter*> line_;
};

}  // namespace flair::orchestrator
