// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "cli/batch/result_writer.h"
#include "cli/batch/results_file.h"
#include "cli/session/session.h"

namespace flair::cli {

// Fetches the results of a batch as its jobs end: files to a ResultWriter, a row each to a ResultsFile. Both and how
// far it got agree after a kill: what is not remembered is fetched again, what is remembered never. Several jobs are
// fetched at a time, and no more are held.
class Collector {
 public:
  struct Options {
    KeptFiles kept;
    int fetch_count = 8;
    // Files of jobs that failed are kept too, as far as they came.
    bool keep_failed = true;
    // Most rows that are held until their files are settled.
    size_t held_limit = 2048;
    // Ends when so many jobs have been seen, not with the batch.
    std::optional<int64_t> end_after;
  };

  // All outlive it.
  Collector(Session& session, ResultsFile& results, ResultWriter& writer, const Options& options);

  // Collects until the batch is closed and all its jobs have ended and are fetched. CANCELLED when the session is
  // stopped; then, as after every error, another collector goes on where this one was.
  absl::Status Run(const std::string& batch_id);

  // Of ends that were fetched by this collector.
  int64_t fetched_count() const { return fetched_count_; }

 private:
  // An end on its way: seen, fetched, settled, remembered.
  struct End {
    int64_t sequence = 0;
    v1::Job job;
  };
  struct Fetched {
    int64_t sequence = 0;
    ResultRow row;
    int64_t ticket = 0;
  };

  absl::StatusOr<int64_t> FirstSequence();
  absl::Status Watch(const std::string& batch_id);
  // Whether the end is still to be fetched.
  absl::StatusOr<bool> IsNew(const v1::WatchBatchResponse& end);
  // Waits for room; false when the collector is ending.
  bool Enqueue(const v1::WatchBatchResponse& end);
  void FetchEnds();
  absl::StatusOr<Fetched> Fetch(const End& end);
  absl::StatusOr<std::vector<v1::Artifact>> FetchArtifacts(const v1::Job& job, ResultRow& row);
  void RememberEnds();
  absl::Status Remember(bool all);
  void Fail(const absl::Status& status);

  Session& session_;
  ResultsFile& results_;
  ResultWriter& writer_;
  const Options& options_;

  std::mutex mutex_;
  // Somebody may go on: there is something to fetch, room, something to remember, or the end.
  std::condition_variable changed_;
  std::deque<End> waiting_;
  std::deque<Fetched> fetched_;
  // Seen and not remembered, and whether it is fetched.
  std::map<int64_t, bool> open_;
  int64_t last_seen_ = 0;
  // Nothing follows.
  bool seen_all_ = false;
  bool fetched_all_ = false;
  // The first thing that went wrong; nothing more is fetched then.
  absl::Status status_;
  runtime::Cancellation failed_;
  std::atomic<int64_t> fetched_count_ = 0;
};

}  // namespace flair::cli
