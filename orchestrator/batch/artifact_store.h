// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "flair/v1/artifact.pb.h"
#include "orchestrator/store/artifact_id.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {

// Artifacts by their ids. An artifact is whole or not there; putting one twice is harmless. Several processes, on
// several machines where the form allows, may use one store. Thread-safe.
class ArtifactStore {
 public:
  virtual ~ArtifactStore() = default;

  // Stores those of which no good copy is there already; others count as stored anew. They survive the end of any
  // process. RESOURCE_EXHAUSTED when there is no room, UNAVAILABLE when the store cannot be reached; then some of them
  // may be there.
  virtual absl::Status PutAll(std::span<const SealedArtifact> artifacts) = 0;

  // Gives one artifact its id, stores it and names it.
  absl::StatusOr<v1::ArtifactRef> Put(v1::Artifact& artifact) {
    SealedArtifact sealed = SealArtifact(artifact);
    RETURN_IF_ERROR(PutAll(std::span(&sealed, 1)));
    return std::move(sealed.ref);
  }

  // NOT_FOUND when there is none, DATA_LOSS when what is stored does not have that id, INVALID_ARGUMENT when `id` is no
  // id, UNAVAILABLE when the store cannot be reached.
  virtual absl::StatusOr<v1::Artifact> Get(const std::string& id) = 0;

  // Returns when these survive a loss of power too, as far as the store's machines go. Those that are gone are left
  // out: who needs them finds out by Get.
  virtual absl::Status Flush(std::span<const v1::ArtifactRef> artifacts) = 0;

  // A mark in the order in which artifacts are stored: what is stored from now on comes after it.
  virtual absl::StatusOr<int64_t> Mark() = 0;

  // Deletes those that were last stored before the mark; passes over those that are not there. Returns how many went.
  virtual absl::StatusOr<int64_t> Delete(std::span<const std::string> ids, int64_t mark) = 0;
};

}  // namespace flair::orchestrator
