// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/clock/clock.h"

namespace flair::orchestrator {

// What the end of a call says about its worker. docs/workers.md has the table.
enum class Verdict {
  // It works: it answered, or refused the request for what is in it. A refusal counts when another one says the same.
  kGood,
  // It has more to do than it takes (RESOURCE_EXHAUSTED). Others may have room.
  kFull,
  // It could not be reached, is gone or serves something else (UNAVAILABLE, UNIMPLEMENTED). Others may be there.
  kLost,
  // It failed (INTERNAL, UNKNOWN, DATA_LOSS), gave an answer that breaks the protocol, or refused what another one
  // answers.
  kFailed,
  // It did not answer in time (DEADLINE_EXCEEDED).
  kLate,
  // Another one that was asked because it was late answered before it: it is not called for a while.
  kBeaten,
  // Nothing: we gave the call up.
  kNone,
};

Verdict VerdictOf(const absl::Status& status);

// A circuit breaker: whether a worker is called although calls to it failed. Closed: it is. Open, after `failure_limit`
// failures in a row: not until `recovery` has passed; then one trial call is made, whose end closes the circuit or
// opens it again. Times are those of Clock::Elapsed. Not thread-safe.
class Circuit {
 public:
  Circuit(int failure_limit, absl::Duration recovery) : failure_limit_(failure_limit), recovery_(recovery) {}

  bool Allows(absl::Duration now) const { return !open_ || (now >= trial_time_ && !on_trial_); }
  bool open() const { return open_; }
  // When an open one allows a trial.
  absl::Duration trial_time() const { return trial_time_; }

  // A call begins, which Allows() allowed. Says whether it is the trial.
  bool Begin() { return on_trial_ = open_; }

  // The ends of a call. A call that was not the trial and fails while the circuit is open began before it opened, and
  // changes nothing.
  void Succeed();
  void GiveUp(bool on_trial);
  // Says whether the circuit opened, which it does as after `failures` more.
  bool Fail(bool on_trial, absl::Duration now, int failures = 1);

  // The worker has come back: the next call is the trial.
  void AllowTrial() { trial_time_ = -absl::InfiniteDuration(); }

 private:
  const int failure_limit_;
  const absl::Duration recovery_;
  int failures_in_a_row_ = 0;
  bool open_ = false;
  bool on_trial_ = false;
  absl::Duration trial_time_;
};

using WorkerId = int64_t;

// See StageCallConfig and OrchestratorConfig for the limits.
struct WorkerPoolOptions {
  // For messages: the stage, and the setting that says where its workers are.
  std::string stage;
  std::string setting;
  // Is told which worker is not called any more, and why.
  std::function<void(const std::string&)> log = [](const std::string&) {};
  int in_flight_limit = 16;
  int failure_limit = 5;
  absl::Duration recovery = absl::Seconds(5);
  // After so long a call is late; by what is usual when unset.
  std::optional<absl::Duration> patience = {};
  // So long after the last worker went, jobs may wait for one (IsOutage).
  absl::Duration outage_limit = absl::Hours(24);
};

// A call's right to a worker; given back with End.
struct Place {
  WorkerId worker = 0;
  bool on_trial = false;
  // When the call began (Clock::Elapsed).
  absl::Duration begin_time = {};
  // The worker's, when the call began.
  std::optional<std::string> revision = {};
  // What is asked, such as "SolveRequest": how long that takes is remembered.
  std::string request = {};
};

// The workers of one stage, and the calls that want one. Calls go to the workers in rotation: to the one that has
// waited longest, of those that are ready, have room and whose circuit is closed; one whose trial is due comes first.
// When none is free, calls wait in line. Knows nothing of gRPC. Thread-safe.
class WorkerPool {
 public:
  WorkerPool(WorkerPoolOptions options, const runtime::Clock& clock) : options_(std::move(options)), clock_(clock) {}

  // ---- Who is there

  // A worker that is about to be reached.
  WorkerId Add(const std::string& address);
  // It is there and of that revision (StageClients::Revision).
  void SetReady(WorkerId id, std::optional<std::string> revision);
  // It was lost and may be back in a moment.
  void SetConnecting(WorkerId id);
  // It is not there, or cannot be used. UNAVAILABLE, or how calls are to end if all are like that.
  void SetGone(WorkerId id, absl::Status reason);
  void Remove(WorkerId id);
  // All workers that are known now are added; or why they could not be looked up. Until then calls wait.
  void SetFound(absl::Status lookup);

  // ---- Calls

  // A place at a worker other than those `tried` already; waits in line while all are full, and while the broken ones
  // may not be tried. UNAVAILABLE when none is there; CANCELLED or DEADLINE_EXCEEDED by `call`.
  absl::StatusOr<Place> Take(const std::set<WorkerId>& tried, runtime::CallContext& call);
  // The same without waiting; nothing when no worker has room.
  std::optional<Place> TryTake(const std::set<WorkerId>& tried);
  // One at another worker, full or not, for the question of `place`: of the same revision where there is one that
  // works.
  std::optional<Place> TakeWitness(const Place& place, const std::set<WorkerId>& tried);
  // `why`, for the log: how the call ended.
  void End(const Place& place, Verdict verdict, const absl::Status& why = absl::OkStatus());
  // How long to wait for an answer before another one is asked as well: clearly longer than is usual.
  absl::Duration Patience(const Place& place) const;

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
    Circuit circuit;
    Presence presence = Presence::kConnecting;
    // Why it is gone.
    absl::Status reason = {};
    std::optional<std::string> revision = {};
    // Number of the last call that it took, of all calls of the stage.
    int64_t last_use = 0;
    int in_flight = 0;
    // A full one is left alone until `rest_end`.
    absl::Duration rest = {};
    absl::Duration rest_end = -absl::InfiniteDuration();
    // Moving mean of what answered calls took.
    absl::Duration mean = {};
    int64_t call_count = 0;
    int64_t failure_count = 0;
    // What the last call that failed asked: answers to other questions say nothing against that.
    std::string failing = {};

    bool HasRoom(int limit, absl::Duration now) const;
    v1::WorkerStatus Status(const std::string& stage) const;
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

    bool done() const { return place.has_value() || !end.ok(); }
  };
  // What a call for which there is no place may wait for: nothing, since no worker is there; room, or a worker that is
  // being reached; the trial of a broken one.
  enum class WaitFor { kNothing, kRoom, kTrial };

  absl::StatusOr<Place> WaitInLine(const std::set<WorkerId>& tried, bool only_asks, runtime::CallContext& call);
  // Calls `change` with the worker if it is still there, then serves the line.
  template <typename Change>
  void Update(WorkerId id, const Change& change);

  // All below: with mutex_ held.
  void ServeLine();
  std::optional<Place> Begin(const std::set<WorkerId>& tried);
  Place BeginAt(WorkerId id, Worker& worker);
  // The worker that would take the next call; null when there is none.
  const Worker* Next(const std::set<WorkerId>& tried) const;
  void EndCall(Worker& worker, const Place& place, Verdict verdict, const absl::Status& why);
  WaitFor WhatFor(const std::set<WorkerId>& tried) const;
  absl::Status NoneIsThere() const;
  // `status`, which jobs may wait for the end of unless it has gone on too long.
  absl::Status Outage(absl::Status status);
  // How long until something may change that nobody reports.
  absl::Duration NextChange(absl::Duration now) const;

  const WorkerPoolOptions options_;
  const runtime::Clock& clock_;
  mutable std::mutex mutex_;
  std::map<WorkerId, Worker> workers_;
  // How looking for workers ended; nothing before.
  std::optional<absl::Status> lookup_;
  WorkerId next_worker_ = 1;
  int64_t call_count_ = 0;
  // How often a circuit opened.
  int64_t openings_ = 0;
  // Longest of the last answers, by what was asked.
  std::map<std::string, absl::Duration> usual_;
  // Since when no worker is there or works, as far as anybody asked.
  std::optional<absl::Duration> outage_begin_;
  std::list<Waiter*> line_;
};

}  // namespace flair::orchestrator
