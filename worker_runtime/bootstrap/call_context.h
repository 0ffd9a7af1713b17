// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <any>
#include <atomic>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "absl/status/status.h"
#include "absl/time/time.h"
#include "worker_runtime/clock/clock.h"

namespace flair::runtime {

// A request to stop that somebody may make once. Work that can stop polls cancelled(); work that blocks elsewhere
// leaves a callback. Thread-safe.
class Cancellation {
 public:
  bool cancelled() const { return cancelled_.load(std::memory_order_acquire); }

  // Runs every callback once, in the calling thread. Further calls do nothing.
  void Cancel() {
    const std::lock_guard lock(mutex_);
    cancelled_.store(true, std::memory_order_release);
    for (auto& [key, callback] : callbacks_) callback();
    callbacks_.clear();
  }

 private:
  friend class OnCancel;
  std::atomic<bool> cancelled_ = false;
  std::mutex mutex_;
  std::map<int, std::function<void()>> callbacks_;
  int next_key_ = 0;
};

// Keeps a callback registered while it lives; runs it at once when the cancellation has already been asked for. The
// callback never runs after the destructor has returned. The callback must not create or destroy an OnCancel of the
// same cancellation. `cancellation` must outlive it.
class OnCancel {
 public:
  OnCancel(Cancellation& cancellation, std::function<void()> callback) : cancellation_(cancellation) {
    const std::lock_guard lock(cancellation.mutex_);
    key_ = cancellation.next_key_++;
    if (cancellation.cancelled()) {
      callback();
    } else {
      cancellation.callbacks_.emplace(key_, std::move(callback));
    }
  }
  ~OnCancel() {
    const std::lock_guard lock(cancellation_.mutex_);
    cancellation_.callbacks_.erase(key_);
  }
  OnCancel(const OnCancel&) = delete;
  OnCancel& operator=(const OnCancel&) = delete;

 private:
  Cancellation& cancellation_;
  int key_;
};

// What a handler knows about the call it answers. Knows nothing of gRPC, so that handlers and solvers can be tested
// without it. Thread-safe once the handler has it.
class CallContext {
 public:
  CallContext(std::string request_id, absl::Time deadline, const Clock& clock)
      : request_id_(std::move(request_id)), deadline_(deadline), clock_(clock) {}

  // A call without id or deadline, for tests and for commands that call a library directly.
  CallContext() : CallContext("", absl::InfiniteFuture(), SystemClock()) {}

  // The caller's key for this piece of work; the log key. May be empty.
  const std::string& request_id() const { return request_id_; }
  void set_request_id(std::string request_id) { request_id_ = std::move(request_id); }

  // Who calls: a name for the log, empty when it is not known; and what the service that let them in knows of them.
  struct Caller {
    std::string name;
    std::any rights;
  };
  const Caller& caller() const { return caller_; }
  void set_caller(Caller caller) { caller_ = std::move(caller); }

  // When the caller stops waiting; absl::InfiniteFuture() when never.
  absl::Time deadline() const { return deadline_; }

  // True when nobody waits for the answer any more. Cheap enough to poll once per restart or per sentence.
  bool cancelled() const { return cancellation_.cancelled() || clock_.Now() >= deadline_; }

  // OK, or CANCELLED or DEADLINE_EXCEEDED: what a handler that stops early returns.
  absl::Status CheckAlive() const {
    if (cancellation_.cancelled()) return absl::CancelledError("the caller cancelled the call");
    if (clock_.Now() >= deadline_) return absl::DeadlineExceededError("the call's deadline has passed");
    return absl::OkStatus();
  }

  // To cancel the call, or to be told of it (see OnCancel).
  Cancellation& cancellation() { return cancellation_; }

 private:
  std::string request_id_;
  Caller caller_;
  const absl::Time deadline_;
  const Clock& clock_;
  Cancellation cancellation_;
};

}  // namespace flair::runtime
