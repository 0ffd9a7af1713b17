// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/executor/bounded_executor.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace flair::runtime {

BoundedExecutor::BoundedExecutor(int thread_limit, int queue_limit)
    : thread_limit_(std::max(thread_limit, 1)), queue_limit_(std::max(queue_limit, 1)) {}

BoundedExecutor::~BoundedExecutor() { Stop(); }

bool BoundedExecutor::TrySubmit(std::function<void()> task) {
  std::lock_guard lock(mutex_);
  const int taken = running_ + static_cast<int>(queue_.size());
  if (stopped_ || taken >= thread_limit_ + queue_limit_) return false;
  queue_.push_back(std::move(task));
  const int thread_count = static_cast<int>(threads_.size());
  if (thread_count < thread_limit_ && thread_count <= taken) {
    try {
      threads_.emplace_back([this] { Work(); });
    } catch (const std::system_error&) {
      // The machine gives no more threads: those that are there do the work.
      if (threads_.empty()) {
        queue_.pop_back();
        return false;
      }
    }
  }
  wake_.notify_one();
  return true;
}

void BoundedExecutor::Stop() {
  std::vector<std::thread> threads;
  {
    std::lock_guard lock(mutex_);
    stopped_ = true;
    threads.swap(threads_);
  }
  wake_.notify_all();
  for (std::thread& thread : threads) thread.join();
}

int BoundedExecutor::queued() const {
  std::lock_guard lock(mutex_);
  return static_cast<int>(queue_.size());
}

int BoundedExecutor::running() const {
  std::lock_guard lock(mutex_);
  return running_;
}

void BoundedExecutor::Work() {
  std::unique_lock lock(mutex_);
  while (true) {
    wake_.wait(lock, [this] { return stopped_ || !queue_.empty(); });
    if (queue_.empty()) return;
    std::function<void()> task = std::move(queue_.front());
    queue_.pop_front();
    ++running_;
    lock.unlock();
    task();
    task = nullptr;
    lock.lock();
    --running_;
  }
}

}  // namespace flair::runtime
