// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/time/time.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "orchestrator/workers/circuit.h"
#include "orchestrator/workers/verdict.h"
#include "orchestrator/workers/worker_load.h"

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

// The workers of one stage: who is there, how they do, and which of them is best. That is the one where a call would
// end first, as far as is known: the least of (calls in flight + 1) × what a call takes, doubled for every failure in a
// row, among those that are there, have room and are not broken; of equals, the one that has waited longest. A broken
// one comes first when its trial is due. Times are those of Clock::Elapsed. Not thread-safe; WorkerPool says what else
// its methods promise.
class WorkerRoster {
 public:
  explicit WorkerRoster(WorkerPoolOptions options) : options_(std::move(options)) {}

  // ---- Who is there

  WorkerId Add(const std::string& address);
  void SetReady(WorkerId id, std::optional<std::string> revision);
  void SetConnecting(WorkerId id);
  void SetGone(WorkerId id, absl::Status reason);
  void Remove(WorkerId id) { workers_.erase(id); }
  void SetFound(absl::Status lookup) { lookup_ = std::move(lookup); }

  // ---- Calls

  // A place at the best worker but those `tried`; nothing when none has room.
  std::optional<Place> Begin(const std::set<WorkerId>& tried, absl::Duration now);
  // The worker that would take the next call, full or not, with its revision; there is nothing to give back.
  std::optional<Place> Next(const std::set<WorkerId>& tried, absl::Duration now) const;
  void End(const Place& place, Verdict verdict, absl::Duration now);
  void ReportBadAnswer(const Place& place, absl::Duration now);

  // What a call for which there is no place may wait for: nothing, since none is there (NoneIsThere says why); that one
  // has room or comes; that a broken one works on trial.
  enum class Wait { kNone, kRoom, kTrial };
  Wait WhatFor(const std::set<WorkerId>& tried) const;
  absl::Status NoneIsThere() const;
  // None that is there works.
  absl::Status NoneWorks() const;
  // How often a circuit opened.
  int64_t openings() const { return openings_; }
  // How long until something may change that nobody tells of.
  absl::Duration NextChange(absl::Duration now) const;

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

    v1::WorkerStatus Status() const;
  };

  Worker* Find(WorkerId id);
  // 0 when there is none.
  WorkerId Best(const std::set<WorkerId>& tried, bool with_room, absl::Duration now) const;
  // What a call takes at those workers of which that is known.
  absl::Duration Typical() const;

  const WorkerPoolOptions options_;
  std::map<WorkerId, Worker> workers_;
  // Of looking for workers; nothing before.
  std::optional<absl::Status> lookup_;
  WorkerId next_worker_ = 1;
  int64_t next_call_ = 1;
  int64_t openings_ = 0;
};

}  // namespace flair::orchestrator
