// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstdint>
#include <list>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "orchestrator/workers/circuit.h"
#include "orchestrator/workers/verdict.h"
#include "orchestrator/workers/worker_load.h"
#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/clock/clock.h"

namespace flair::orchestrator {

using WorkerId = int64_t;

// Which worker is to take a call. See StageCallConfig for the limits.
struct WorkerPoolOptions {
  // For messages: the stage, and the setting that says where its workers are.
  std::string stage;
  std::string setting;
  int in_flight_limit = 16;
  int failure_limit = 5;
  absl::Duration recovery = absl::Seconds(5);
  // Decides which of equal workers is first, so that many orchestrators do not all begin with the same one.
  uint64_t seed = 0;
};

// A call's right to a worker; given back with End.
struct Place {
  WorkerId worker = 0;
  int64_t call = 0;
  bool on_trial = false;
  // Of the worker, before the call.
  int failures_in_a_row = 0;
  // The worker's, when the call began.
  std::optional<std::string> revision;
};

// The workers of one stage: who is there, how they do, and who takes the next call. That is the one where it would end
// first, as far as is known: the least of (calls in flight + 1) × what a call takes, doubled for every failure in a
// row, among those that are there, have room and are not broken; of equals, the one that has waited longest. A broken
// one comes first when its trial is due. When all are full, calls wait in line. Knows nothing of gRPC. Thread-safe.
class WorkerPool {
 public:
  WorkerPool(WorkerPoolOptions options, const runtime::Clock& clock) : options_(std::move(options)), clock_(clock) {}

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
  enum class Presence { kConnecting, kReady, kGone };
  struct Worker {
    std::string address;
    Presence presence = Presence::kConnecting;
    absl::Status reason = {};
    std::optional<std::string> revision = {};
    Circuit circuit;
    WorkerLoad load;
    // Grows with every call; below zero before the first.
    int64_t last_use;
    int64_t call_count = 0;
    int64_t failure_count = 0;
  };
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
  enum class Wait { kNone, kRoom, kTrial };

  absl::StatusOr<Place> WaitInLine(const std::set<WorkerId>& tried, bool only_asks, runtime::CallContext& call);
  // All below: with mutex_ held.
  std::map<WorkerId, Worker>::iterator Best(const std::set<WorkerId>& tried, bool with_room, absl::Duration now);
  Place Begin(WorkerId id, Worker& worker, absl::Duration now);
  Wait WhatFor(const std::set<WorkerId>& tried) const;
  absl::Status NoneIsThere() const;
  absl::Duration Typical() const;
  absl::Duration NextChange(absl::Duration now) const;
  void ServeLine();
  void Serve(Waiter& waiter, absl::Duration now, std::optional<Wait>& untried);

  const WorkerPoolOptions options_;
  const runtime::Clock& clock_;
  mutable std::mutex mutex_;
  std::map<WorkerId, Worker> workers_;
  std::list<Waiter*> line_;
  // Of looking for workers; nothing before.
  std::optional<absl::Status> lookup_;
  WorkerId next_worker_ = 1;
  int64_t next_call_ = 1;
  // How often a circuit opened.
  int64_t openings_ = 0;
};

}  // namespace flair::orchestrator
