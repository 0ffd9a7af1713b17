// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/workers/worker_pool.h"

#include <algorithm>
#include <utility>

namespace flair::orchestrator {
namespace {

// Of a thread in line that looks by itself whether something has changed.
constexpr absl::Duration kShortestWait = absl::Milliseconds(1);
constexpr absl::Duration kLongestWait = absl::Hours(1);

}  // namespace

WorkerId WorkerPool::Add(const std::string& address) {
  std::lock_guard lock(mutex_);
  return roster_.Add(address);
}

void WorkerPool::SetReady(WorkerId id, std::optional<std::string> revision) {
  std::lock_guard lock(mutex_);
  roster_.SetReady(id, std::move(revision));
  ServeLine();
}

void WorkerPool::SetConnecting(WorkerId id) {
  std::lock_guard lock(mutex_);
  roster_.SetConnecting(id);
  ServeLine();
}

void WorkerPool::SetGone(WorkerId id, absl::Status reason) {
  std::lock_guard lock(mutex_);
  roster_.SetGone(id, std::move(reason));
  ServeLine();
}

void WorkerPool::Remove(WorkerId id) {
  std::lock_guard lock(mutex_);
  roster_.Remove(id);
  ServeLine();
}

void WorkerPool::SetFound(absl::Status lookup) {
  std::lock_guard lock(mutex_);
  roster_.SetFound(std::move(lookup));
  ServeLine();
}

std::optional<Place> WorkerPool::TryTake(const std::set<WorkerId>& tried) {
  std::lock_guard lock(mutex_);
  return roster_.Begin(tried, clock_.Elapsed());
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
    const absl::Duration patience = std::min(roster_.NextChange(clock_.Elapsed()), call.deadline() - clock_.Now());
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
  std::optional<WorkerRoster::Wait> untried;
  for (Waiter* waiter : line_) {
    if (waiter->place.has_value() || !waiter->end.ok()) continue;
    Serve(*waiter, now, untried);
    if (waiter->place.has_value() || !waiter->end.ok()) waiter->wake.notify_all();
  }
}

// `untried`: what calls that may go to any worker wait for, once one of them found no place; then none does.
void WorkerPool::Serve(Waiter& waiter, absl::Duration now, std::optional<WorkerRoster::Wait>& untried) {
  using Wait = WorkerRoster::Wait;
  const bool takes_any = waiter.tried.empty() && !waiter.only_asks;
  if (!takes_any || !untried.has_value()) {
    waiter.place = waiter.only_asks ? roster_.Next(waiter.tried, now) : roster_.Begin(waiter.tried, now);
    if (waiter.place.has_value()) return;
  }
  const Wait wait = takes_any && untried.has_value() ? *untried : roster_.WhatFor(waiter.tried);
  if (takes_any) untried = wait;
  if (wait == Wait::kNone) {
    waiter.end = roster_.NoneIsThere();
  } else if (wait == Wait::kTrial && waiter.openings.has_value() && roster_.openings() > *waiter.openings) {
    waiter.end = roster_.NoneWorks();
  } else if (wait == Wait::kTrial && !waiter.openings.has_value()) {
    waiter.openings = roster_.openings();
  }
}

void WorkerPool::End(const Place& place, Verdict verdict) {
  std::lock_guard lock(mutex_);
  roster_.End(place, verdict, clock_.Elapsed());
  ServeLine();
}

void WorkerPool::ReportBadAnswer(const Place& place) {
  std::lock_guard lock(mutex_);
  roster_.ReportBadAnswer(place, clock_.Elapsed());
  ServeLine();
}

int WorkerPool::waiting() const {
  std::lock_guard lock(mutex_);
  return static_cast<int>(line_.size());
}

std::vector<v1::WorkerStatus> WorkerPool::Status() const {
  std::lock_guard lock(mutex_);
  return roster_.Status();
}

}  // namespace flair::orchestrator
