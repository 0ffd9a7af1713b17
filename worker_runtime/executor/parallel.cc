// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/executor/parallel.h"

#include <algorithm>
#include <atomic>
#include <system_error>
#include <thread>
#include <vector>

namespace flair::runtime {

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
