// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "cli/batch/batch_input.h"
#include "cli/batch/results_file.h"
#include "cli/session/session.h"

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

}  // namespace flair::cli
