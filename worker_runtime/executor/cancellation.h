// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <mutex>

namespace flair::runtime {

// A request to stop that somebody may make once. Work that can stop polls cancelled(); work that blocks elsewhere
// leaves a callback. Thread-safe.
class Cancellation {
 public:
  bool cancelled() const { return cancelled_.load(std::memory_order_acquire); }

  // Runs every callback once, in the calling thread. Further calls do nothing.
  void Cancel();

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
  OnCancel(Cancellation& cancellation, std::function<void()> callback);
  ~OnCancel();
  OnCancel(const OnCancel&) = delete;
  OnCancel& operator=(const OnCancel&) = delete;

 private:
  Cancellation& cancellation_;
  int key_;
};

}  // namespace flair::runtime
