// SPDX-License-Identifier: GPL-3.0-or-later
// Runs, collects and deletes a batch from a terminal.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <thread>

#include "absl/status/status.h"
#include "cli/batch/batch_folder.h"
#include "cli/batch/batch_report.h"
#include "cli/batch/submission.h"
#include "cli/session/batch_session.h"
#include "flair/v1/orchestrator_service.pb.h"
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

// How a batch is followed to its end.
struct BatchRunOptions {
  // What to do when nobody takes jobs; empty when this process does.
  std::string remedy;
  // Submits and does not wait for results.
  bool submit_only = false;
  bool quiet = false;
  // The summary as JSON on standard output instead of text on standard error.
  bool json = false;
};

// Submits the lines of `input`, when there is one, and meanwhile collects into `folder`, which remembers the batch,
// what ends. Returns when all has ended: OK when every line became a job that succeeded, otherwise a status with the
// exit code of docs/batches.md. After an interruption or an error the same call goes on where this one was.
absl::Status RunBatch(const v1::Batch& batch, BatchSession& session, BatchFolder& folder, Submission* submission,
                      Interruption& interruption, const BatchRunOptions& options);

// How a batch ended, as an exit code; OK when all succeeded. `name` is how people call it in the next command.
absl::Status EndOf(const BatchReport& report, const std::string& name);

// The end of a batch's memory, as a person sees it.

struct DeletionOptions {
  // Does not ask.
  bool yes = false;
  // One JSON object on standard output instead of text.
  bool json = false;
};

// Why the batch cannot be deleted yet, and what to do; OK when it can.
absl::Status CheckHasEnded(const v1::Batch& batch);

// Deletes the batch with its jobs and what only they have, step by step, and says so: how far it came, when it takes
// long, and what was freed. Asks the person at the terminal first; where none is, `yes` must be set. What it cannot do,
// and being stopped in the middle, end with the exit codes of exit_code.h.
absl::Status DeleteWholeBatch(const v1::Batch& batch, BatchSession& batches, const DeletionOptions& options);

}  // namespace flair::cli
