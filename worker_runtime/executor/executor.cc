// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/executor/executor.h"

#include <algorithm>
#include <atomic>
#include <system_error>
#include <utility>

namespace flair::runtime {
namespace {}  // namespace

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

absl::Status ForEach(const Workers& workers, int count, const std::function<void(int)>& work) {
  std::atomic<int> next = 0;
  std::atomic<bool> stop = false;
  const auto run = [&] {
    for (int i = next++; i < count && !stop; i = next++) work(i);
  };
  std::vector<std::thread> threads;
  try {
    for (int i = 1; i < std::min(workers.thread_count, count); ++i) threads.emplace_back(run);
  } catch (const std::system_error&) {
    // No more threads to be had: those that are there do the work.
  }
  absl::Status status;
  for (int i = next++; i < count && status.ok(); i = next++) {
    work(i);
    if (workers.check_alive) status = workers.check_alive();
  }
  if (!status.ok()) stop = true;
  for (std::thread& thread : threads) thread.join();
  return status;
}

}  // namespace flair::runtime
