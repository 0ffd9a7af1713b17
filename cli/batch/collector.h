// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "cli/batch/results_file.h"
#include "cli/output/output_folder.h"
#include "cli/session/session.h"
#include "flair/v1/artifact.pb.h"
#include "flair/v1/job.pb.h"

namespace flair::cli {

// Puts the files of jobs where they stay. What it made and has not settled is gone, or as good as never made, when the
// process dies. Thread-safe.
class ResultWriter {
 public:
  struct Place {
    // Relative to the batch's folder: the job's folder, or the file that holds it.
    std::string path;
    // Says when it is settled.
    int64_t ticket = 0;
  };

  virtual ~ResultWriter() = default;

  // Instead of what an earlier run of the job left, if anything. FAILED_PRECONDITION when it cannot be written.
  virtual absl::StatusOr<Place> Write(int64_t batch_index, const std::vector<OutputFile>& files) = 0;

  // Settles what can be: its files survive a kill and, as far as the disk keeps its word, a loss of power. With `all`,
  // everything that was written.
  virtual absl::Status Settle(bool all) = 0;

  // Whether what was written under that ticket is settled.
  virtual bool IsSettled(int64_t ticket) = 0;
};

// "000123": at least six digits.
std::string IndexName(int64_t batch_index);

// FOLDER/jobs/000/000123/FILE: a folder for each job, a thousand in each folder.
std::unique_ptr<ResultWriter> MakeJobFolders(const std::filesystem::path& folder);

// FOLDER/shards/shard-000004.tar with the entries 000123.FILE of `shard_size` jobs each in the order in which they
// ended, as WebDataset reads them, and FOLDER/shards/index.json, which lists them. A shard is there when it is
// complete; what an earlier process left of a beginning is removed.
absl::StatusOr<std::unique_ptr<ResultWriter>> MakeTarShards(const std::filesystem::path& folder, int shard_size);

// What of a job's results is kept: words with commas between, see docs/batches.md.
class KeptFiles {
 public:
  static constexpr char kDefault[] = "layout,pictures,report";

  // INVALID_ARGUMENT names the word and says which there are.
  static absl::StatusOr<KeptFiles> Parse(const std::string& words);
  // The same set in one form, whatever the order of the words was.
  std::string Words() const;

  // Whether anything of such an artifact is kept.
  bool Needs(v1::ArtifactKind kind) const;
  bool empty() const { return words_.empty(); }

  // The files that are kept of a job's artifacts, which are in stage order; and job.json, unless nothing is kept.
  std::vector<OutputFile> FilesOf(const v1::Job& job, const std::vector<v1::Artifact>& artifacts) const;

 private:
  bool Has(const std::string& word) const { return words_.contains(word); }
  void AddPicture(const v1::Preview& preview, std::vector<OutputFile>& files) const;

  std::set<std::string> words_;
};

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
