// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <thread>

#include "worker_runtime/bootstrap/call_context.h"

namespace flair::cli {

// Turns ^C and SIGTERM into a request to stop while it lives; a second one ends the process at once with exit code 130.
// One at a time.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  // Asked for by a signal, or by whoever finds that nothing can go on.
  runtime::Cancellation& stop() { return stop_; }
  bool by_signal() const { return by_signal_; }

 private:
  runtime::Cancellation stop_;
  std::atomic<bool> by_signal_ = false;
  int pipe_[2] = {-1, -1};
  std::thread thread_;
};

}  // namespace flair::cli
