// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "cli/batch/results_file.h"

namespace flair::cli {

// Where a batch is, as its folder remembers it.
struct BatchPlace {
  std::string batch_id;
  // What people know it by.
  std::string label;
  std::string orchestrator;
  // The local store; empty when it is elsewhere.
  std::string store;
  // Of a queue in JetStream, without credentials; see EngineFlags.
  std::string engine;
  std::string queue;
  std::string artifacts;
  // What the jobs are kept as, and in how large shards (0: in folders).
  std::string kept;
  int shard_size = 0;
};

// The folder that --out names: results.db, rejected.jsonl, jobs/ or shards/. One process at a time may hold it.
class BatchFolder {
 public:
  // Makes the folder when it is missing. FAILED_PRECONDITION when it cannot be written, when another process holds it,
  // or when a file is in its place.
  static absl::StatusOr<std::unique_ptr<BatchFolder>> Hold(const std::filesystem::path& path);
  ~BatchFolder();

  // Whether there is one at the path, without holding it.
  static bool IsAt(const std::filesystem::path& path);
  // What one remembers. NOT_FOUND when it has no batch.
  static absl::StatusOr<BatchPlace> ReadPlace(const std::filesystem::path& path);

  // What it remembers; without an id when it has no batch yet.
  absl::StatusOr<BatchPlace> Place();
  absl::Status SetPlace(const BatchPlace& place);

  const std::filesystem::path& path() const { return path_; }
  ResultsFile& results() { return *results_; }

 private:
  BatchFolder(std::filesystem::path path, int lock) : path_(std::move(path)), lock_(lock) {}

  const std::filesystem::path path_;
  const int lock_;
  std::unique_ptr<ResultsFile> results_;
};

// The file of results in a batch's folder.
std::filesystem::path ResultsPath(const std::filesystem::path& folder);

}  // namespace flair::cli
