// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/executor/bounded_executor.h"

#include <algorithm>
#include <utility>

namespace flair::runtime {

BoundedExecutor::BoundedExecutor(int thread_limit, int queue_limit)
    : thread_limit_(std::max(thread_limit, 1)), queue_limit_(std::max(queue_limit, 1)) {}

BoundedExecutor::~BoundedExecutor() { Stop(); }

bool BoundedExecutor::TrySubmit(std::function<void()> task) {
  std::lock_guard lock(mutex_);
  const int waiting = static_cast<int>(queue_.size());
  const int free_threads = idle_ + thread_limit_ - static_cast<int>(threads_.size());
  if (stopped_ || waiting >= queue_limit_ + free_threads) return false;
  queue_.push_back(std::move(task));
  if (idle_ < static_cast<int>(queue_.size()) && static_cast<int>(threads_.size()) < thread_limit_) {
    threads_.emplace_back([this] { Work(); });
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

void BoundedExecutor::Work() {
  std::unique_lock lock(mutex_);
  while (true) {
    ++idle_;
    wake_.wait(lock, [this] { return stopped_ || !queue_.empty(); });
    --idle_;
    if (queue_.empty()) return;
    std::function<void()> task = std::move(queue_.front());
    queue_.pop_front();
    lock.unlock();
    task();
    task = nullptr;
    lock.lock();
  }
}

}  // namespace flair::runtime
