// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "cli/batch/batch_progress.h"
#include "cli/session/batch_session.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::cli {

// Shows on standard error how a batch stands while it lives: on a terminal in one line that changes, elsewhere in a
// line a minute. Says so when a batch waits and nobody takes jobs. Thread-safe.
class BatchMonitor {
 public:
  struct Options {
    bool quiet = false;
    // What to do when nobody takes jobs; empty when this process does.
    std::string remedy;
    // Adds what only this process knows.
    std::function<void(BatchStanding&)> complete = [](BatchStanding&) {};
  };

  // `session` outlives it.
  BatchMonitor(BatchSession& session, std::string batch_id, Options options);
  ~BatchMonitor();

  // A line of its own, once for each text.
  void Say(const std::string& text);

 private:
  void Run();
  void Show(const v1::Batch& batch, absl::Time now);
  void WarnIfUnserved(const v1::Batch& batch, absl::Time now);
  void Print(const std::string& line);

  BatchSession& session_;
  const std::string batch_id_;
  const Options options_;
  const bool on_terminal_;
  std::mutex mutex_;
  std::string last_said_;
  bool line_shown_ = false;
  RecentRate rate_;
  absl::Time next_line_;
  absl::Time next_check_;
  runtime::Cancellation end_;
  std::thread thread_;
};

}  // namespace flair::cli
