// SPDX-License-Identifier: GPL-3.0-or-later
// Runs, collects and deletes a batch from a terminal.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "absl/status/status.h"
#include "absl/time/time.h"
#include "cli/batch/batch_input.h"
#include "cli/batch/results_file.h"
#include "cli/batch/submission.h"
#include "cli/progress/progress.h"
#include "cli/session/session.h"
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
absl::Status RunBatch(const v1::Batch& batch, Session& session, BatchFolder& folder, Submission* submission,
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
absl::Status DeleteWholeBatch(const v1::Batch& batch, Session& batches, const DeletionOptions& options);

// What a person sees while a batch runs.

// The progress of a batch.
struct BatchStanding {
  v1::Batch batch;
  int64_t rejected_count = 0;
  int64_t fetched_count = 0;
  // Still reading lines.
  bool submitting = false;
  double per_second = 0;
};

// "412/1000 · 41 % · 12.3/s · 0:48 left · 4 running · failed: 3 worker, 1 infeasible". On one line; `width` columns at
// most when it is not 0.
std::string StandingText(const BatchStanding& standing, size_t width = 0);

// "0:48", "2:05:10", "3 days".
std::string TimeLeftText(absl::Duration left);

// "3 worker, 1 infeasible"; empty when nothing failed.
std::string FailuresText(const v1::Batch& batch);

// "active", "paused", "cancelled".
std::string BatchStateWord(v1::BatchState state);

int64_t EndedCount(const v1::Batch& batch);

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
  BatchMonitor(Session& session, std::string batch_id, Options options);
  ~BatchMonitor();

  // A line of its own, once for each text.
  void Say(const std::string& text);

 private:
  void Run();
  void Show(const v1::Batch& batch, absl::Time now);
  void WarnIfUnserved(const v1::Batch& batch, absl::Time now);
  void Print(const std::string& line);

  Session& session_;
  const std::string batch_id_;
  const Options options_;
  const bool on_terminal_;
  std::mutex mutex_;
  std::string last_said_;
  bool line_shown_ = false;
  RateMeter rate_{absl::Minutes(1)};
  absl::Time next_line_;
  absl::Time next_check_;
  runtime::Cancellation end_;
  std::thread thread_;
};

}  // namespace flair::cli
