// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/workers/worker_pool.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "orchestrator/pipeline/stage_clients.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

// Of a thread in line that looks by itself whether something has changed.
constexpr absl::Duration kShortestWait = absl::Milliseconds(1);
constexpr absl::Duration kLongestWait = absl::Hours(1);

// How long a worker that is full is left alone: doubled as long as it stays full.
constexpr absl::Duration kFirstRest = absl::Milliseconds(20);
constexpr absl::Duration kLongestRest = absl::Seconds(2);

// Part of the newest call in the mean.
constexpr double kNewest = 0.2;

// A call is late after some seconds, and some times what the longest of the last ones took.
constexpr absl::Duration kLeastPatience = absl::Seconds(4);
constexpr double kUsualTimes = 2;
constexpr absl::Duration kUnknownUsual = absl::Seconds(2);
constexpr double kForgotten = 0.95;

}  // namespace

Verdict VerdictOf(const absl::Status& status) {
  switch (status.code()) {
    case absl::StatusCode::kResourceExhausted:
      // The request cannot be carried to any worker.
      return IsMessageTooLarge(status) ? Verdict::kGood : Verdict::kFull;
    case absl::StatusCode::kUnavailable:
    case absl::StatusCode::kUnimplemented:
      return Verdict::kLost;
    case absl::StatusCode::kInternal:
    case absl::StatusCode::kUnknown:
    case absl::StatusCode::kDataLoss:
      return Verdict::kFailed;
    case absl::StatusCode::kDeadlineExceeded:
      return Verdict::kLate;
    case absl::StatusCode::kCancelled:
      return Verdict::kNone;
    default:
      return Verdict::kGood;
  }
}

void Circuit::Succeed() {
  failures_in_a_row_ = 0;
  open_ = false;
  on_trial_ = false;
}

void Circuit::GiveUp(bool on_trial) {
  if (on_trial) on_trial_ = false;
}

bool Circuit::Fail(bool on_trial, absl::Duration now, int failures) {
  if (open_ && !on_trial) return false;
  on_trial_ = false;
  failures_in_a_row_ += failures;
  if (failures_in_a_row_ < failure_limit_) return false;
  open_ = true;
  trial_time_ = now + recovery_;
  return true;
}

bool WorkerPool::Worker::HasRoom(int limit, absl::Duration now) const {
  return circuit.Allows(now) && in_flight < limit && now >= rest_end;
}

v1::WorkerStatus WorkerPool::Worker::Status(const std::string& stage) const {
  v1::WorkerStatus status;
  status.set_stage(stage);
  status.set_address(address);
  if (presence == Presence::kGone) status.set_state(v1::WORKER_STATE_GONE);
  if (presence == Presence::kReady) status.set_state(circuit.open() ? v1::WORKER_STATE_BROKEN : v1::WORKER_STATE_READY);
  status.set_in_flight_count(in_flight);
  status.set_call_count(call_count);
  status.set_failure_count(failure_count);
  const int64_t nanoseconds = absl::ToInt64Nanoseconds(mean);
  status.mutable_call_duration()->set_seconds(nanoseconds / 1000000000);
  status.mutable_call_duration()->set_nanos(static_cast<int>(nanoseconds % 1000000000));
  return status;
}

WorkerId WorkerPool::Add(const std::string& address) {
  const std::lock_guard lock(mutex_);
  const WorkerId id = next_worker_++;
  workers_.emplace(id, Worker{.address = address, .circuit = Circuit(options_.failure_limit, options_.recovery)});
  return id;
}

template <typename Change>
void WorkerPool::Update(WorkerId id, const Change& change) {
  const std::lock_guard lock(mutex_);
  if (const auto found = workers_.find(id); found != workers_.end()) change(found->second);
  ServeLine();
}

void WorkerPool::SetReady(WorkerId id, std::optional<std::string> revision) {
  Update(id, [&](Worker& worker) {
    if (worker.presence != Presence::kReady) {
      worker.rest = worker.mean = absl::ZeroDuration();
      worker.rest_end = -absl::InfiniteDuration();
      worker.circuit.AllowTrial();
    }
    worker.presence = Presence::kReady;
    worker.revision = std::move(revision);
    outage_begin_.reset();
  });
}

void WorkerPool::SetConnecting(WorkerId id) {
  Update(id, [](Worker& worker) { worker.presence = Presence::kConnecting; });
}

void WorkerPool::SetGone(WorkerId id, absl::Status reason) {
  Update(id, [&](Worker& worker) {
    worker.presence = Presence::kGone;
    worker.reason = std::move(reason);
  });
}

void WorkerPool::Remove(WorkerId id) {
  const std::lock_guard lock(mutex_);
  workers_.erase(id);
  ServeLine();
}

void WorkerPool::SetFound(absl::Status lookup) {
  const std::lock_guard lock(mutex_);
  lookup_ = std::move(lookup);
  ServeLine();
}

std::optional<Place> WorkerPool::TryTake(const std::set<WorkerId>& tried) {
  const std::lock_guard lock(mutex_);
  return Begin(tried);
}

std::optional<Place> WorkerPool::TakeWitness(const Place& place, const std::set<WorkerId>& tried) {
  const std::lock_guard lock(mutex_);
  std::pair<const WorkerId, Worker>* best = nullptr;
  for (auto& entry : workers_) {
    const Worker& worker = entry.second;
    if (worker.presence != Presence::kReady || worker.circuit.open() || tried.contains(entry.first)) continue;
    if (best == nullptr || worker.revision == place.revision) best = &entry;
  }
  return best == nullptr ? std::nullopt : std::optional(BeginAt(best->first, best->second));
}

absl::Duration WorkerPool::Patience(const Place& place) const {
  if (options_.patience.has_value()) return *options_.patience;
  const std::lock_guard lock(mutex_);
  const auto usual = usual_.find(place.request);
  return kLeastPatience + kUsualTimes * (usual == usual_.end() ? kUnknownUsual : usual->second);
}

absl::StatusOr<Place> WorkerPool::Take(const std::set<WorkerId>& tried, runtime::CallContext& call) {
  return WaitInLine(tried, false, call);
}

absl::StatusOr<std::optional<std::string>> WorkerPool::Revision(runtime::CallContext& call) {
  ASSIGN_OR_RETURN(Place place, WaitInLine({}, true, call));
  return std::move(place.revision);
}

absl::StatusOr<Place> WorkerPool::WaitInLine(const std::set<WorkerId>& tried, bool only_asks,
                                             runtime::CallContext& call) {
  Waiter waiter{.tried = tried, .only_asks = only_asks};
  bool cancelled = false;
  // Before the lock and after it, since a cancel comes with locks of its own.
  runtime::OnCancel guard(call.cancellation(), [&] {
    const std::lock_guard lock(mutex_);
    cancelled = true;
    waiter.wake.notify_all();
  });
  std::unique_lock lock(mutex_);
  const auto in_line = line_.insert(line_.end(), &waiter);
  while (true) {
    ServeLine();
    if (waiter.done()) break;
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

// First come, first served; but nobody is kept from a worker that those before cannot use.
void WorkerPool::ServeLine() {
  // Once a call that may go to any worker finds no place, none like it does.
  bool any_has_room = true;
  for (Waiter* waiter : line_) {
    if (waiter->done()) continue;
    if (waiter->only_asks) {
      if (const Worker* next = Next(waiter->tried)) waiter->place = Place{.revision = next->revision};
    } else if (any_has_room || !waiter->tried.empty()) {
      waiter->place = Begin(waiter->tried);
      if (waiter->tried.empty()) any_has_room = waiter->place.has_value();
    }
    if (!waiter->place.has_value()) {
      const WaitFor wait = WhatFor(waiter->tried);
      if (wait == WaitFor::kNothing) {
        waiter->end = waiter->tried.empty() ? Outage(NoneIsThere()) : NoneIsThere();
      } else if (wait == WaitFor::kTrial && waiter->openings.has_value() && openings_ > *waiter->openings) {
        waiter->end = Outage(
            Unavailable("no {} worker is usable: calls to all of them fail ({})", options_.stage, options_.setting));
      } else if (wait == WaitFor::kTrial && !waiter->openings.has_value()) {
        waiter->openings = openings_;
      }
    }
    if (waiter->done()) waiter->wake.notify_all();
  }
}

std::optional<Place> WorkerPool::Begin(const std::set<WorkerId>& tried) {
  const absl::Duration now = clock_.Elapsed();
  std::pair<const WorkerId, Worker>* best = nullptr;
  for (auto& entry : workers_) {
    const Worker& worker = entry.second;
    if (worker.presence != Presence::kReady || tried.contains(entry.first)) continue;
    if (!worker.HasRoom(options_.in_flight_limit, now)) continue;
    // An open circuit with room is one whose trial is due.
    if (best == nullptr || worker.circuit.open() || worker.last_use < best->second.last_use) best = &entry;
    if (worker.circuit.open()) break;
  }
  if (best == nullptr) return std::nullopt;
  return BeginAt(best->first, best->second);
}

Place WorkerPool::BeginAt(WorkerId id, Worker& worker) {
  ++worker.in_flight;
  worker.last_use = ++call_count_;
  return Place{
      .worker = id, .on_trial = worker.circuit.Begin(), .begin_time = clock_.Elapsed(), .revision = worker.revision};
}

const WorkerPool::Worker* WorkerPool::Next(const std::set<WorkerId>& tried) const {
  const Worker* next = nullptr;
  for (const auto& [id, worker] : workers_) {
    if (worker.presence != Presence::kReady || tried.contains(id)) continue;
    const auto order = [](const Worker& w) { return std::pair(w.circuit.open(), w.last_use); };
    if (next == nullptr || order(worker) < order(*next)) next = &worker;
  }
  return next;
}

void WorkerPool::End(const Place& place, Verdict verdict, const absl::Status& why) {
  Update(place.worker, [&](Worker& worker) { EndCall(worker, place, verdict, why); });
}

void WorkerPool::EndCall(Worker& worker, const Place& place, Verdict verdict, const absl::Status& why) {
  const absl::Duration now = clock_.Elapsed();
  const absl::Duration duration = now - place.begin_time;
  --worker.in_flight;
  // A call that came with hardly any time left says nothing of the worker.
  if (verdict == Verdict::kLate && duration < worker.mean / 2) verdict = Verdict::kNone;
  if (verdict != Verdict::kNone) ++worker.call_count;
  switch (verdict) {
    case Verdict::kGood:
      worker.mean = worker.mean == absl::ZeroDuration() ? duration : worker.mean + (duration - worker.mean) * kNewest;
      worker.rest = absl::ZeroDuration();
      if (place.on_trial || worker.failing.empty() || worker.failing == place.request) {
        worker.circuit.Succeed();
        worker.failing.clear();
      }
      outage_begin_.reset();
      if (why.ok()) usual_[place.request] = std::max(duration, usual_[place.request] * kForgotten);
      break;
    case Verdict::kFull:
      worker.circuit.GiveUp(place.on_trial);
      // Calls that were under way together are refused together; that is one refusal.
      if (now < worker.rest_end) break;
      worker.rest = std::clamp(worker.rest * 2, kFirstRest, kLongestRest);
      worker.rest_end = now + worker.rest;
      break;
    case Verdict::kLost:
    case Verdict::kFailed:
    case Verdict::kLate:
    case Verdict::kBeaten:
      ++worker.failure_count;
      worker.failing = place.request;
      if (!worker.circuit.Fail(place.on_trial, now, verdict == Verdict::kBeaten ? options_.failure_limit : 1)) break;
      ++openings_;
      options_.log(fmt::format("{} worker at {} is not called for {}: its calls fail, the last one so: {}",
                               options_.stage, worker.address, absl::FormatDuration(options_.recovery),
                               std::string(why.message())));
      break;
    case Verdict::kNone:
      worker.circuit.GiveUp(place.on_trial);
      break;
  }
}

WorkerPool::WaitFor WorkerPool::WhatFor(const std::set<WorkerId>& tried) const {
  if (!lookup_.has_value()) return WaitFor::kRoom;
  WaitFor wait = WaitFor::kNothing;
  for (const auto& [id, worker] : workers_) {
    if (worker.presence == Presence::kGone || tried.contains(id)) continue;
    if (worker.presence == Presence::kConnecting || !worker.circuit.open()) return WaitFor::kRoom;
    wait = WaitFor::kTrial;
  }
  return wait;
}

absl::Status WorkerPool::NoneIsThere() const {
  if (workers_.empty()) {
    const std::string why = lookup_->ok() ? "its name has no address" : std::string(lookup_->message());
    return Unavailable("there is no {} worker: {}; start one or fix {}", options_.stage, why, options_.setting);
  }
  // A reason that no patience mends is for those who can mend it.
  for (const auto& [id, worker] : workers_) {
    if (worker.presence == Presence::kGone && !absl::IsUnavailable(worker.reason)) return worker.reason;
  }
  const Worker& first = workers_.begin()->second;
  const std::string reason(first.reason.message());
  if (workers_.size() == 1) {
    return Unavailable("{} worker at {} is not reachable: {}; start it or fix {}", options_.stage, first.address,
                       reason, options_.setting);
  }
  return Unavailable("none of the {} {} workers is reachable; the one at {}: {}; start them or fix {}", workers_.size(),
                     options_.stage, first.address, reason, options_.setting);
}

absl::Status WorkerPool::Outage(absl::Status status) {
  const absl::Duration now = clock_.Elapsed();
  if (!outage_begin_.has_value()) outage_begin_ = now;
  const bool may_end = absl::IsUnavailable(status) && now - *outage_begin_ < options_.outage_limit;
  return may_end ? OfOutage(std::move(status)) : status;
}

absl::Duration WorkerPool::NextChange(absl::Duration now) const {
  absl::Duration next = absl::InfiniteDuration();
  for (const auto& [id, worker] : workers_) {
    if (worker.presence != Presence::kReady) continue;
    for (const absl::Duration time : {worker.rest_end, worker.circuit.trial_time()}) {
      if (time > now) next = std::min(next, time - now);
    }
  }
  return next;
}

int WorkerPool::waiting() const {
  const std::lock_guard lock(mutex_);
  return static_cast<int>(line_.size());
}

std::vector<v1::WorkerStatus> WorkerPool::Status() const {
  const std::lock_guard lock(mutex_);
  std::vector<v1::WorkerStatus> all;
  for (const auto& [id, worker] : workers_) all.push_back(worker.Status(options_.stage));
  std::ranges::sort(all, {}, [](const v1::WorkerStatus& status) { return status.address(); });
  return all;
}

}  // namespace flair::orchestrator
