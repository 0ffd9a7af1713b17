// SPDX-License-Identifier: GPL-3.0-or-later
// Runs, collects and deletes a batch from a terminal.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

#include "absl/status/status.h"
#include "absl/time/time.h"
#include "cli/batch/batch_input.h"
#include "cli/batch/results_file.h"
#include "cli/progress/progress.h"
#include "cli/session/session.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::cli {

// rejected.jsonl: the lines that are no briefs, one JSON object each: {"line": 7, "reason": "...", "text": "..."}.
class RejectedLines {
 public:
  explicit RejectedLines(std::filesystem::path path) : path_(std::move(path)) {}

  // Goes on behind the first `size_bytes` of what an earlier submission wrote and forgets the rest of it.
  absl::Status Open(int64_t size_bytes);
  // Of long texts the beginning.
  void Add(int64_t line, const std::string& reason, std::string_view text);
  // Returns when all is written; FAILED_PRECONDITION when it is not.
  absl::Status Flush();
  int64_t size_bytes() const { return size_bytes_; }

 private:
  const std::filesystem::path path_;
  std::ofstream file_;
  int64_t size_bytes_ = 0;
};

// Puts the lines of a file into a batch, page by page, and closes it. Memory is bounded by a page. Where it got to is
// in `results` after every page, so that a submission that was killed goes on; pages that the batch has are not sent
// again.
class Submission {
 public:
  struct Options {
    // What lines take that do not say otherwise.
    v1::JobSpec defaults;
    // Jobs of each brief, with consecutive seeds, [1, 500].
    int seed_count = 1;
    // The batch's folder, for rejected.jsonl.
    std::filesystem::path folder;
    // Told, from the submitting thread, why it has to wait.
    std::function<void(const std::string& why)> waits = [](const std::string&) {};
  };

  // All outlive the submission.
  Submission(Session& session, ResultsFile& results, const BatchInput& input, const Options& options)
      : session_(session),
        results_(results),
        input_(input),
        options_(options),
        rejected_(options.folder / "rejected.jsonl") {}

  // The request_id of this file with these options.
  static std::string RequestId(const BatchInput& input, const Options& options, const std::string& label);

  // Submits what `batch` does not have yet and closes it. INVALID_ARGUMENT when no line is a brief, or when the file
  // changes meanwhile; errors of the session and of files otherwise.
  absl::Status Run(const v1::Batch& batch);

  int64_t submitted_count() const { return submitted_count_; }
  int64_t rejected_count() const { return rejected_count_; }

 private:
  absl::Status Restore(const v1::Batch& batch);
  void Take(const Line& line);
  // Sends what has been gathered and remembers it.
  absl::Status SendPage(bool last);
  absl::Status Send(const v1::AddToBatchRequest& request);
  // Of a page that the orchestrator refuses, what it takes; the rest is rejected like lines that are no briefs.
  absl::Status SendOneByOne();
  absl::Status Remember();

  Session& session_;
  ResultsFile& results_;
  const BatchInput& input_;
  const Options& options_;
  RejectedLines rejected_;

  // Jobs that the batch had at the beginning.
  int64_t known_count_ = 0;
  v1::AddToBatchRequest page_;
  size_t page_bytes_ = 0;
  // Of the page's jobs.
  std::vector<ResultRow> rows_;
  // Where the line behind the last one that was taken begins.
  int64_t next_offset_ = 0;
  int64_t next_line_ = 1;
  std::atomic<int64_t> submitted_count_ = 0;
  std::atomic<int64_t> rejected_count_ = 0;
};

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
