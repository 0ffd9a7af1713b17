// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/service/status_reporter.h"

#include <chrono>
#include <utility>

namespace flair::orchestrator {

StatusReporter::StatusReporter(WorkQueue& queue, std::function<v1::OrchestratorStatus()> status, spdlog::logger& logger)
    : queue_(queue), status_(std::move(status)), logger_(logger), thread_([this] { Run(); }) {}

StatusReporter::~StatusReporter() {
  {
    std::lock_guard lock(mutex_);
    stopping_ = true;
    wake_.notify_all();
  }
  thread_.join();
}

void StatusReporter::Run() {
  bool failed = false;
  std::unique_lock lock(mutex_);
  while (!stopping_) {
    lock.unlock();
    const absl::Status status = queue_.ReportStatus(status_());
    // Once per outage.
    if (!status.ok() && !failed) logger_.warn("cannot report to the queue: {}", std::string(status.message()));
    failed = !status.ok();
    lock.lock();
    wake_.wait_for(lock, std::chrono::seconds(2), [&] { return stopping_; });
  }
}

}  // namespace flair::orchestrator
