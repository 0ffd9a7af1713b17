// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/artifact.pb.h"
#include "orchestrator/batch/work_queue.h"
#include "orchestrator/store/database.h"

namespace flair::orchestrator {

// Artifacts as files, FOLDER/ab/abcdef….pb, named by their ids. A file is whole or not there as far as processes see:
// it is written beside its place and renamed. Only Flush waits for the disk; a loss of power before may leave a damaged
// file, which Get notices. Several processes may share a folder.
class ArtifactFiles final : public ArtifactStore {
 public:
  explicit ArtifactFiles(std::string folder) : folder_(std::move(folder)) {}

  // Makes the folder. UNAVAILABLE when that is not possible or it cannot be written to.
  static absl::StatusOr<std::unique_ptr<ArtifactStore>> Open(const std::string& folder);
  static absl::Status MakeFolder(const std::string& folder);

  absl::Status PutAll(std::span<const SealedArtifact> artifacts) override;
  absl::StatusOr<v1::Artifact> Get(const std::string& id) override;
  absl::Status Flush(std::span<const v1::ArtifactRef> artifacts) override;
  // A time of the folder's own file system, nanoseconds since 1970; takes some milliseconds.
  absl::StatusOr<int64_t> Mark() override;
  absl::StatusOr<int64_t> Delete(std::span<const std::string> ids, int64_t mark) override;

  std::string PathOf(const std::string& id) const;

  // Ids of files that begin so; `prefix` has two characters at least.
  std::vector<std::string> FindIds(const std::string& prefix) const;

 private:
  absl::Status PutOne(const SealedArtifact& artifact) const;

  const std::string folder_;
};

// Artifacts in a folder of this machine: small ones as rows of FOLDER/small.db, which is written and flushed once for
// all of a job, larger ones as files (see ArtifactFiles), which a database would have to copy. What is there as a file
// is found whatever its size. Several processes may share a folder, several machines may not: SQLite's locks do not
// hold over a network. Errors also as Database. Thread-safe.
class LocalArtifacts final : public ArtifactStore {
 public:
  // Makes the folder. UNAVAILABLE when that is not possible or it cannot be written to, or as Database::Open.
  static absl::StatusOr<std::unique_ptr<LocalArtifacts>> Open(const std::string& folder);

  absl::Status PutAll(std::span<const SealedArtifact> artifacts) override;
  absl::StatusOr<v1::Artifact> Get(const std::string& id) override;
  absl::Status Flush(std::span<const v1::ArtifactRef> artifacts) override;
  absl::StatusOr<int64_t> Mark() override;
  absl::StatusOr<int64_t> Delete(std::span<const std::string> ids, int64_t mark) override;

  // Ids that begin so, sorted. `prefix` has two characters at least.
  absl::StatusOr<std::vector<std::string>> FindIds(const std::string& prefix);

 private:
  LocalArtifacts(const std::string& folder, std::unique_ptr<Database> rows) : files_(folder), rows_(std::move(rows)) {}

  ArtifactFiles files_;
  const std::unique_ptr<Database> rows_;
};

}  // namespace flair::orchestrator
