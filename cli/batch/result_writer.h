// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "cli/output/output_folder.h"
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

}  // namespace flair::cli
