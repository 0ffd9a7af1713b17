// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "absl/status/status.h"

namespace flair::runtime {

// A fixed number of threads and a queue of bounded length, in order of arrival. Threads start when first needed. Knows
// nothing of gRPC and uses std::mutex only, so that it can be run under the thread sanitizer. Thread-safe.
class BoundedExecutor {
 public:
  // At most `thread_limit` tasks run and at most `queue_limit` more wait; both at least 1.
  BoundedExecutor(int thread_limit, int queue_limit);

  // As Stop().
  ~BoundedExecutor();

  BoundedExecutor(const BoundedExecutor&) = delete;
  BoundedExecutor& operator=(const BoundedExecutor&) = delete;

  // Takes the task, or returns false without keeping it when the queue is full or the executor has stopped.
  bool TrySubmit(std::function<void()> task);

  // Takes no more tasks, runs those that wait, returns when all have ended. May be called more than once, but not by a
  // task.
  void Stop();

  // Tasks that wait; for metrics and tests.
  int queued() const;

  // Tasks that run.
  int running() const;

  int thread_limit() const { return thread_limit_; }
  int queue_limit() const { return queue_limit_; }

 private:
  void Work();

  const int thread_limit_;
  const int queue_limit_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<std::function<void()>> queue_;
  std::vector<std::thread> threads_;
  int running_ = 0;
  bool stopped_ = false;
};

// How work is spread: never what comes of it.
struct Workers {
  int thread_count = 1;
  std::function<absl::Status()> check_alive;  // asked from the calling thread; may be empty
};

// Calls work(i) once for every i in [0, count), on up to thread_count threads of which the caller is one; on fewer when
// the machine gives no more. Work must only write what belongs to its i, so that the number of threads decides nothing,
// and must not throw. Ends early with what check_alive says.
absl::Status ForEach(const Workers& workers, int count, const std::function<void(int)>& work);

}  // namespace flair::runtime
