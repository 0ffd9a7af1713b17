// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of the end of jobs' memory; see WorkQueue::DeleteJob and
// docs/decisions/0024-what-ended-can-be-deleted.md.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "flair/v1/job.pb.h"
#include "flair/v1/orchestrator_service.pb.h"

namespace flair::orchestrator {

// What one step of a deletion did.
struct Deleted {
  int64_t job_count = 0;
  int64_t artifact_count = 0;
  // Nothing is left of what was to be deleted.
  bool done = false;
};

// Alone standing jobs and batches that ended long ago.
struct EndedPage {
  std::vector<std::string> job_ids;
  std::vector<std::string> batch_ids;
  // Where the next page begins; empty when this was the last.
  std::string next;
};

// FAILED_PRECONDITION when the job waits or runs, or goes only with its batch; when the batch is open or, as `ended`
// says, a job of it waits or runs.
absl::Status CheckDeletable(const v1::Job& job);
absl::Status CheckDeletable(const v1::Batch& batch, bool ended);

// NOT_FOUND: what a run is told that found or stored an artifact which was then deleted with the last job that had it.
absl::Status ArtifactIsGone(const std::string& artifact_id);
bool IsArtifactGone(const absl::Status& status);

}  // namespace flair::orchestrator
