// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "flair/v1/artifact.pb.h"
#include "flair/v1/job.pb.h"

namespace flair::cli {

// Jobs and their artifacts, wherever they are kept.
class ArtifactShelf {
 public:
  virtual ~ArtifactShelf() = default;

  // NOT_FOUND when it is not kept here; DATA_LOSS when it is damaged.
  virtual absl::StatusOr<v1::Artifact> GetArtifact(const std::string& id) = 0;
  // Ids that begin so, sorted; `prefix` has at least two digits.
  virtual absl::StatusOr<std::vector<std::string>> FindIds(const std::string& prefix) = 0;
  // NOT_FOUND when there is no such job.
  virtual absl::StatusOr<v1::Job> GetJob(const std::string& id) = 0;
  // For messages: "the store " and its folder, or "the orchestrator at " and its address.
  virtual std::string name() const = 0;
};

// A job store's folder, read directly: nothing is started, and where there is none none is made.
std::unique_ptr<ArtifactShelf> MakeStoreShelf(const std::string& folder);

}  // namespace flair::cli
