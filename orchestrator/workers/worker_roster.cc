// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/workers/worker_roster.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace flair::orchestrator {
namespace {

// Beyond this failures in a row make no more of a difference.
constexpr int kFailuresThatCount = 20;

// Workers up to so many times as slow as the fastest count as equally fast: calls differ, and the fastest must not get
// all of them.
constexpr double kEquallyFast = 2;

// FNV-1a of the address, begun with the seed; below zero.
int64_t FirstUse(uint64_t seed, const std::string& address) {
  uint64_t hash = 14695981039346656037u ^ seed;
  for (const char c : address) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return -1 - static_cast<int64_t>(hash >> 1);
}

bool CountsAgainst(Verdict verdict) {
  return verdict == Verdict::kLost || verdict == Verdict::kFailed || verdict == Verdict::kLate;
}

}  // namespace

WorkerId WorkerRoster::Add(const std::string& address) {
  const WorkerId id = next_worker_++;
  workers_.emplace(id, Worker{.address = address,
                              .circuit = Circuit(options_.failure_limit, options_.recovery),
                              .load = WorkerLoad(options_.in_flight_limit),
                              .last_use = FirstUse(options_.seed, address)});
  return id;
}

void WorkerRoster::SetReady(WorkerId id, std::optional<std::string> revision) {
  Worker* worker = Find(id);
  if (worker == nullptr) return;
  if (worker->presence != Presence::kReady) {
    worker->load.Forget();
    worker->circuit.AllowTrial();
  }
  worker->presence = Presence::kReady;
  worker->revision = std::move(revision);
}

void WorkerRoster::SetConnecting(WorkerId id) {
  if (Worker* worker = Find(id)) worker->presence = Presence::kConnecting;
}

void WorkerRoster::SetGone(WorkerId id, absl::Status reason) {
  Worker* worker = Find(id);
  if (worker == nullptr) return;
  worker->presence = Presence::kGone;
  worker->reason = std::move(reason);
}

WorkerRoster::Worker* WorkerRoster::Find(WorkerId id) {
  const auto found = workers_.find(id);
  return found == workers_.end() ? nullptr : &found->second;
}

std::optional<Place> WorkerRoster::Begin(const std::set<WorkerId>& tried, absl::Duration now) {
  const WorkerId id = Best(tried, true, now);
  if (id == 0) return std::nullopt;
  Worker& worker = workers_.at(id);
  const int64_t call = next_call_++;
  worker.load.Begin(call, now);
  worker.last_use = call;
  return Place{.worker = id,
               .call = call,
               .on_trial = worker.circuit.Begin(),
               .failures_in_a_row = worker.circuit.failures_in_a_row(),
               .revision = worker.revision};
}

std::optional<Place> WorkerRoster::Next(const std::set<WorkerId>& tried, absl::Duration now) const {
  const WorkerId id = Best(tried, false, now);
  if (id == 0) return std::nullopt;
  return Place{.worker = id, .revision = workers_.at(id).revision};
}

WorkerId WorkerRoster::Best(const std::set<WorkerId>& tried, bool with_room, absl::Duration now) const {
  struct Candidate {
    WorkerId id;
    const Worker* worker;
    absl::Duration estimate;
  };
  const absl::Duration typical = Typical();
  absl::Duration fastest = absl::InfiniteDuration();
  std::vector<Candidate> candidates;
  for (const auto& [id, worker] : workers_) {
    if (worker.presence != Presence::kReady || tried.contains(id)) continue;
    if (with_room && (!worker.circuit.Allows(now) || !worker.load.HasRoom(now))) continue;
    if (with_room && worker.circuit.open()) return id;
    candidates.push_back({id, &worker, worker.load.Estimate(now, typical)});
    fastest = std::min(fastest, candidates.back().estimate);
  }
  const Candidate* best = nullptr;
  absl::Duration least;
  for (const Candidate& candidate : candidates) {
    const Worker& worker = *candidate.worker;
    const int failures = std::min(worker.circuit.failures_in_a_row(), kFailuresThatCount);
    const absl::Duration end =
        std::max(candidate.estimate, fastest * kEquallyFast) * (worker.load.in_flight() + 1) * std::exp2(failures);
    if (best != nullptr && (end > least || (end == least && worker.last_use > best->worker->last_use))) continue;
    best = &candidate;
    least = end;
  }
  return best == nullptr ? 0 : best->id;
}

absl::Duration WorkerRoster::Typical() const {
  absl::Duration sum;
  int known = 0;
  for (const auto& [id, worker] : workers_) {
    if (worker.load.mean() == absl::ZeroDuration()) continue;
    sum += worker.load.mean();
    ++known;
  }
  return known == 0 ? absl::ZeroDuration() : sum / known;
}

void WorkerRoster::End(const Place& place, Verdict verdict, absl::Duration now) {
  Worker* worker = Find(place.worker);
  if (worker == nullptr) return;
  if (verdict == Verdict::kGood) {
    worker->load.EndAnswered(place.call, now);
  } else if (verdict == Verdict::kFull) {
    worker->load.EndRefused(place.call, now);
  } else {
    const absl::Duration mean = worker->load.mean();
    // A call that came with hardly any time left says nothing of the worker.
    if (worker->load.EndOtherwise(place.call, now) < mean / 2 && verdict == Verdict::kLate) verdict = Verdict::kNone;
  }
  if (verdict != Verdict::kNone) ++worker->call_count;
  if (CountsAgainst(verdict)) {
    ++worker->failure_count;
    if (worker->circuit.Fail(place.on_trial, now)) ++openings_;
  } else if (verdict == Verdict::kGood) {
    worker->circuit.Succeed();
  } else {
    worker->circuit.GiveUp(place.on_trial);
  }
}

void WorkerRoster::ReportBadAnswer(const Place& place, absl::Duration now) {
  Worker* worker = Find(place.worker);
  if (worker == nullptr) return;
  ++worker->failure_count;
  if (worker->circuit.Retract(place.failures_in_a_row, now)) ++openings_;
}

WorkerRoster::Wait WorkerRoster::WhatFor(const std::set<WorkerId>& tried) const {
  if (!lookup_.has_value()) return Wait::kRoom;
  Wait wait = Wait::kNone;
  for (const auto& [id, worker] : workers_) {
    if (worker.presence == Presence::kGone || tried.contains(id)) continue;
    if (worker.presence == Presence::kConnecting || !worker.circuit.open()) return Wait::kRoom;
    wait = Wait::kTrial;
  }
  return wait;
}

absl::Status WorkerRoster::NoneIsThere() const {
  if (workers_.empty()) {
    const std::string why = lookup_->ok() ? "its name has no address" : std::string(lookup_->message());
    return absl::UnavailableError(
        fmt::format("no {} worker is there: {}; start one or fix {}", options_.stage, why, options_.setting));
  }
  // A reason that no patience mends is for those who can mend it.
  for (const auto& [id, worker] : workers_) {
    if (worker.presence == Presence::kGone && !absl::IsUnavailable(worker.reason)) return worker.reason;
  }
  const Worker& first = workers_.begin()->second;
  const std::string reason(first.reason.message());
  if (workers_.size() == 1) {
    return absl::UnavailableError(fmt::format("{} worker at {} is not reachable: {}; start it or fix {}",
                                              options_.stage, first.address, reason, options_.setting));
  }
  return absl::UnavailableError(fmt::format("none of {} {} workers is reachable: that at {}: {}; start them or fix {}",
                                            workers_.size(), options_.stage, first.address, reason, options_.setting));
}

absl::Status WorkerRoster::NoneWorks() const {
  return absl::UnavailableError(
      fmt::format("no {} worker works: calls to all that are there fail ({})", options_.stage, options_.setting));
}

absl::Duration WorkerRoster::NextChange(absl::Duration now) const {
  absl::Duration next = absl::InfiniteDuration();
  for (const auto& [id, worker] : workers_) {
    if (worker.presence != Presence::kReady) continue;
    for (const absl::Duration time : {worker.load.rest_end(), worker.circuit.trial_time()}) {
      if (time > now) next = std::min(next, time - now);
    }
  }
  return next;
}

v1::WorkerStatus WorkerRoster::Worker::Status() const {
  v1::WorkerStatus status;
  status.set_address(address);
  if (presence == Presence::kGone) status.set_state(v1::WORKER_STATE_GONE);
  if (presence == Presence::kReady) {
    status.set_state(circuit.open() ? v1::WORKER_STATE_BROKEN : v1::WORKER_STATE_READY);
  }
  status.set_in_flight_count(load.in_flight());
  status.set_call_count(call_count);
  status.set_failure_count(failure_count);
  const int64_t nanoseconds = absl::ToInt64Nanoseconds(load.mean());
  status.mutable_call_duration()->set_seconds(nanoseconds / 1000000000);
  status.mutable_call_duration()->set_nanos(static_cast<int>(nanoseconds % 1000000000));
  return status;
}

std::vector<v1::WorkerStatus> WorkerRoster::Status() const {
  std::vector<v1::WorkerStatus> all;
  for (const auto& [id, worker] : workers_) {
    all.push_back(worker.Status());
    all.back().set_stage(options_.stage);
  }
  std::ranges::sort(all, {}, [](const v1::WorkerStatus& status) { return status.address(); });
  return all;
}

}  // namespace flair::orchestrator
