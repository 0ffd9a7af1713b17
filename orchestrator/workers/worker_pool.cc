// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/workers/worker_pool.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace flair::orchestrator {
namespace {

// Beyond this failures in a row make no more of a difference.
constexpr int kFailuresThatCount = 20;

// Workers up to so many times as slow as the fastest count as equally fast: calls differ, and the fastest must not get
// all of them.
constexpr double kEquallyFast = 2;

// Of a thread in line that looks by itself whether something has changed.
constexpr absl::Duration kShortestWait = absl::Milliseconds(1);
constexpr absl::Duration kLongestWait = absl::Hours(1);

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

WorkerId WorkerPool::Add(const std::string& address) {
  std::lock_guard lock(mutex_);
  const WorkerId id = next_worker_++;
  workers_.emplace(id, Worker{.address = address,
                              .circuit = Circuit(options_.failure_limit, options_.recovery),
                              .load = WorkerLoad(options_.in_flight_limit),
                              .last_use = FirstUse(options_.seed, address)});
  return id;
}

void WorkerPool::SetReady(WorkerId id, std::optional<std::string> revision) {
  std::lock_guard lock(mutex_);
  const auto worker = workers_.find(id);
  if (worker == workers_.end()) return;
  if (worker->second.presence != Presence::kReady) {
    worker->second.load.Forget();
    worker->second.circuit.AllowTrial();
  }
  worker->second.presence = Presence::kReady;
  worker->second.revision = std::move(revision);
  ServeLine();
}

void WorkerPool::SetConnecting(WorkerId id) {
  std::lock_guard lock(mutex_);
  const auto worker = workers_.find(id);
  if (worker == workers_.end()) return;
  worker->second.presence = Presence::kConnecting;
  ServeLine();
}

void WorkerPool::SetGone(WorkerId id, absl::Status reason) {
  std::lock_guard lock(mutex_);
  const auto worker = workers_.find(id);
  if (worker == workers_.end()) return;
  worker->second.presence = Presence::kGone;
  worker->second.reason = std::move(reason);
  ServeLine();
}

void WorkerPool::Remove(WorkerId id) {
  std::lock_guard lock(mutex_);
  workers_.erase(id);
  ServeLine();
}

void WorkerPool::SetFound(absl::Status lookup) {
  std::lock_guard lock(mutex_);
  lookup_ = std::move(lookup);
  ServeLine();
}

std::optional<Place> WorkerPool::TryTake(const std::set<WorkerId>& tried) {
  std::lock_guard lock(mutex_);
  const absl::Duration now = clock_.Elapsed();
  const auto best = Best(tried, true, now);
  if (best == workers_.end()) return std::nullopt;
  return Begin(best->first, best->second, now);
}

absl::StatusOr<Place> WorkerPool::Take(const std::set<WorkerId>& tried, runtime::CallContext& call) {
  return WaitInLine(tried, false, call);
}

absl::StatusOr<std::optional<std::string>> WorkerPool::Revision(runtime::CallContext& call) {
  absl::StatusOr<Place> place = WaitInLine({}, true, call);
  if (!place.ok()) return place.status();
  return std::move(place->revision);
}

absl::StatusOr<Place> WorkerPool::WaitInLine(const std::set<WorkerId>& tried, bool only_asks,
                                             runtime::CallContext& call) {
  Waiter waiter{.tried = tried, .only_asks = only_asks};
  bool cancelled = false;
  // Before the lock and after it, since a cancel comes with locks of its own.
  runtime::OnCancel guard(call.cancellation(), [&] {
    std::lock_guard lock(mutex_);
    cancelled = true;
    waiter.wake.notify_all();
  });
  std::unique_lock lock(mutex_);
  const auto in_line = line_.insert(line_.end(), &waiter);
  while (true) {
    ServeLine();
    if (waiter.place.has_value() || !waiter.end.ok()) break;
    if (cancelled || call.cancelled()) {
      waiter.end = call.CheckAlive();
      break;
    }
    const absl::Duration patience = std::min(NextChange(clock_.Elapsed()), call.deadline() - clock_.Now());
    if (patience == absl::InfiniteDuration()) {
      waiter.wake.wait(lock);
    } else {
      waiter.wake.wait_for(lock, absl::ToChronoNanoseconds(std::clamp(patience, kShortestWait, kLongestWait)));
    }
  }
  line_.erase(in_line);
  if (waiter.place.has_value()) return *std::move(waiter.place);
  return waiter.end;
}

// Those who came first are served first, but do not keep others from workers that they cannot use themselves.
void WorkerPool::ServeLine() {
  const absl::Duration now = clock_.Elapsed();
  std::optional<Wait> untried;
  for (Waiter* waiter : line_) {
    if (waiter->place.has_value() || !waiter->end.ok()) continue;
    Serve(*waiter, now, untried);
    if (waiter->place.has_value() || !waiter->end.ok()) waiter->wake.notify_all();
  }
}

// `untried`: what calls that may go to any worker wait for, once one of them found no place; then none does.
void WorkerPool::Serve(Waiter& waiter, absl::Duration now, std::optional<Wait>& untried) {
  const bool takes_any = waiter.tried.empty() && !waiter.only_asks;
  if (!takes_any || !untried.has_value()) {
    const auto best = Best(waiter.tried, !waiter.only_asks, now);
    if (best != workers_.end()) {
      waiter.place = waiter.only_asks ? Place{.worker = best->first, .revision = best->second.revision}
                                      : Begin(best->first, best->second, now);
      return;
    }
  }
  const Wait wait = takes_any && untried.has_value() ? *untried : WhatFor(waiter.tried);
  if (takes_any) untried = wait;
  if (wait == Wait::kNone) {
    waiter.end = NoneIsThere();
  } else if (wait == Wait::kTrial && waiter.openings.has_value() && openings_ > *waiter.openings) {
    waiter.end = absl::UnavailableError(
        fmt::format("no {} worker works: calls to all that are there fail ({})", options_.stage, options_.setting));
  } else if (wait == Wait::kTrial && !waiter.openings.has_value()) {
    waiter.openings = openings_;
  }
}

std::map<WorkerId, WorkerPool::Worker>::iterator WorkerPool::Best(const std::set<WorkerId>& tried, bool with_room,
                                                                  absl::Duration now) {
  const absl::Duration typical = Typical();
  absl::Duration fastest = absl::InfiniteDuration();
  std::vector<std::pair<std::map<WorkerId, Worker>::iterator, absl::Duration>> candidates;
  for (auto it = workers_.begin(); it != workers_.end(); ++it) {
    const Worker& worker = it->second;
    if (worker.presence != Presence::kReady || tried.contains(it->first)) continue;
    if (with_room && (!worker.circuit.Allows(now) || !worker.load.HasRoom(now))) continue;
    if (with_room && worker.circuit.open()) return it;
    candidates.emplace_back(it, worker.load.Estimate(now, typical));
    fastest = std::min(fastest, candidates.back().second);
  }
  auto best = workers_.end();
  absl::Duration least;
  for (const auto& [it, estimate] : candidates) {
    const Worker& worker = it->second;
    const int failures = std::min(worker.circuit.failures_in_a_row(), kFailuresThatCount);
    const absl::Duration end =
        std::max(estimate, fastest * kEquallyFast) * (worker.load.in_flight() + 1) * std::exp2(failures);
    if (best != workers_.end() && (end > least || (end == least && worker.last_use > best->second.last_use))) continue;
    best = it;
    least = end;
  }
  return best;
}

Place WorkerPool::Begin(WorkerId id, Worker& worker, absl::Duration now) {
  const int64_t call = next_call_++;
  worker.load.Begin(call, now);
  worker.last_use = call;
  return {.worker = id,
          .call = call,
          .on_trial = worker.circuit.Begin(),
          .failures_in_a_row = worker.circuit.failures_in_a_row(),
          .revision = worker.revision};
}

// What somebody for whom there is no place may wait for.
WorkerPool::Wait WorkerPool::WhatFor(const std::set<WorkerId>& tried) const {
  if (!lookup_.has_value()) return Wait::kRoom;
  Wait wait = Wait::kNone;
  for (const auto& [id, worker] : workers_) {
    if (worker.presence == Presence::kGone || tried.contains(id)) continue;
    if (worker.presence == Presence::kConnecting || !worker.circuit.open()) return Wait::kRoom;
    wait = Wait::kTrial;
  }
  return wait;
}

absl::Status WorkerPool::NoneIsThere() const {
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

absl::Duration WorkerPool::Typical() const {
  absl::Duration sum;
  int known = 0;
  for (const auto& [id, worker] : workers_) {
    if (worker.load.mean() == absl::ZeroDuration()) continue;
    sum += worker.load.mean();
    ++known;
  }
  return known == 0 ? absl::ZeroDuration() : sum / known;
}

// When something may change that nobody tells of.
absl::Duration WorkerPool::NextChange(absl::Duration now) const {
  absl::Duration next = absl::InfiniteDuration();
  for (const auto& [id, worker] : workers_) {
    if (worker.presence != Presence::kReady) continue;
    for (const absl::Duration time : {worker.load.rest_end(), worker.circuit.trial_time()}) {
      if (time > now) next = std::min(next, time - now);
    }
  }
  return next;
}

void WorkerPool::End(const Place& place, Verdict verdict) {
  std::lock_guard lock(mutex_);
  const auto found = workers_.find(place.worker);
  if (found == workers_.end()) return;
  Worker& worker = found->second;
  const absl::Duration now = clock_.Elapsed();
  if (verdict == Verdict::kGood) {
    worker.load.EndAnswered(place.call, now);
  } else if (verdict == Verdict::kFull) {
    worker.load.EndRefused(place.call, now);
  } else {
    const absl::Duration mean = worker.load.mean();
    // A call that came with hardly any time left says nothing of the worker.
    if (worker.load.EndOtherwise(place.call, now) < mean / 2 && verdict == Verdict::kLate) verdict = Verdict::kNone;
  }
  if (verdict != Verdict::kNone) ++worker.call_count;
  if (CountsAgainst(verdict)) {
    ++worker.failure_count;
    if (worker.circuit.Fail(place.on_trial, now)) ++openings_;
  } else if (verdict == Verdict::kGood) {
    worker.circuit.Succeed();
  } else {
    worker.circuit.GiveUp(place.on_trial);
  }
  ServeLine();
}

void WorkerPool::ReportBadAnswer(const Place& place) {
  std::lock_guard lock(mutex_);
  const auto found = workers_.find(place.worker);
  if (found == workers_.end()) return;
  ++found->second.failure_count;
  if (found->second.circuit.Retract(place.failures_in_a_row, clock_.Elapsed())) ++openings_;
  ServeLine();
}

int WorkerPool::waiting() const {
  std::lock_guard lock(mutex_);
  return static_cast<int>(line_.size());
}

std::vector<v1::WorkerStatus> WorkerPool::Status() const {
  std::lock_guard lock(mutex_);
  std::vector<v1::WorkerStatus> all;
  for (const auto& [id, worker] : workers_) {
    v1::WorkerStatus& status = all.emplace_back();
    status.set_stage(options_.stage);
    status.set_address(worker.address);
    if (worker.presence == Presence::kGone) status.set_state(v1::WORKER_STATE_GONE);
    if (worker.presence == Presence::kReady) {
      status.set_state(worker.circuit.open() ? v1::WORKER_STATE_BROKEN : v1::WORKER_STATE_READY);
    }
    status.set_in_flight_count(worker.load.in_flight());
    status.set_call_count(worker.call_count);
    status.set_failure_count(worker.failure_count);
    const int64_t nanoseconds = absl::ToInt64Nanoseconds(worker.load.mean());
    status.mutable_call_duration()->set_seconds(nanoseconds / 1000000000);
    status.mutable_call_duration()->set_nanos(static_cast<int>(nanoseconds % 1000000000));
  }
  std::ranges::sort(all, {}, [](const v1::WorkerStatus& status) { return status.address(); });
  return all;
}

}  // namespace flair::orchestrator
