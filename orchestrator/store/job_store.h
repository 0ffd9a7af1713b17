// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "orchestrator/store/artifact_table.h"
#include "orchestrator/store/batch_table.h"
#include "orchestrator/store/database.h"
#include "orchestrator/store/deletion_table.h"
#include "orchestrator/store/event_table.h"
#include "orchestrator/store/job_table.h"
#include "orchestrator/store/owner_lock.h"
#include "orchestrator/store/status_table.h"

namespace flair::orchestrator {

// The tables of a store's folder, jobs.db, and this process's claim to be alive, owners/. Several processes may have it
// open. Thread-safe.
class JobStore {
 public:
  // Opens the folder, makes it when missing, and gives back the jobs of processes that died. INVALID_ARGUMENT for an
  // empty path, UNAVAILABLE when the folder cannot be made or written.
  static absl::StatusOr<std::unique_ptr<JobStore>> Open(const std::string& path);

  const std::string& path() const { return path_; }
  // This process, as owner of jobs.
  const std::string& owner() const { return owner_.id(); }
  Database& database() { return *database_; }
  JobTable& jobs() { return jobs_; }
  EventTable& events() { return events_; }
  ArtifactTable& artifacts() { return artifacts_; }
  BatchTable& batches() { return batches_; }
  StatusTable& statuses() { return statuses_; }
  DeletionTable& deletions() { return deletions_; }

  // Makes RUNNING jobs whose process has died QUEUED again.
  absl::Status ReleaseDeadOwners();

  std::string owners_path() const { return path_ + "/owners"; }

 private:
  JobStore(std::string path, std::unique_ptr<Database> database, OwnerLock owner);

  const std::string path_;
  OwnerLock owner_;
  std::unique_ptr<Database> database_;
  JobTable jobs_;
  EventTable events_;
  ArtifactTable artifacts_;
  BatchTable batches_;
  StatusTable statuses_;
  DeletionTable deletions_;
};

}  // namespace flair::orchestrator
