// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "flair/v1/artifact.pb.h"

namespace flair::orchestrator {

// Artifacts as files, FOLDER/ab/abcdef….pb, named by their ids. A file is whole or not there: it is written beside its
// place, flushed to the disk and renamed. Several processes may share a folder. Thread-safe.
class ArtifactFiles {
 public:
  explicit ArtifactFiles(std::string folder) : folder_(std::move(folder)) {}

  // Gives the artifact its id, stores it unless a good copy is there already, and names it.
  absl::StatusOr<v1::ArtifactRef> Put(v1::Artifact& artifact) const;

  // NOT_FOUND when there is no such file, DATA_LOSS when its content does not have that id, INVALID_ARGUMENT when `id`
  // is no id.
  absl::StatusOr<v1::Artifact> Get(const std::string& id) const;

  std::string PathOf(const std::string& id) const;

 private:
  const std::string folder_;
};

}  // namespace flair::orchestrator
