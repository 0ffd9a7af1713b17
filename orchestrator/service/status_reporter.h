// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#include "orchestrator/batch/work_queue.h"
#include "spdlog/logger.h"

namespace flair::orchestrator {

// Tells the other orchestrators of a queue how this one does, every two seconds, from a thread of its own. The
// arguments outlive it.
class StatusReporter {
 public:
  StatusReporter(WorkQueue& queue, std::function<v1::OrchestratorStatus()> status, spdlog::logger& logger);
  ~StatusReporter();

 private:
  void Run();

  WorkQueue& queue_;
  const std::function<v1::OrchestratorStatus()> status_;
  spdlog::logger& logger_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace flair::orchestrator
