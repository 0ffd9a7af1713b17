// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "cli/output/output_folder.h"

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

}  // namespace flair::cli
