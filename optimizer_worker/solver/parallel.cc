// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/solver/parallel.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace flair::optimizer {

void ForEachIndex(int count, int thread_count, const std::function<void(int)>& work) {
  std::atomic<int> next = 0;
  const auto drain = [&] {
    for (int i = next.fetch_add(1); i < count; i = next.fetch_add(1)) work(i);
  };
  std::vector<std::thread> helpers;
  for (int t = 1; t < std::min(thread_count, count); ++t) helpers.emplace_back(drain);
  drain();
  for (std::thread& helper : helpers) helper.join();
}

int ThreadCount(int requested) {
  return requested > 0 ? requested : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

}  // namespace flair::optimizer
