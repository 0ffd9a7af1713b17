// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/job_store.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

namespace flair::orchestrator {

absl::StatusOr<std::unique_ptr<JobStore>> JobStore::Open(const std::string& path) {
  if (path.empty()) return absl::InvalidArgumentError("store_path: missing; expected a folder for jobs and artifacts");
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) {
    return absl::UnavailableError(fmt::format("store_path: cannot make the folder {}: {}", path, error.message()));
  }
  auto database = Database::Open(path + "/jobs.db");
  if (!database.ok()) return database.status();
  auto owner = OwnerLock::Acquire(path + "/owners");
  if (!owner.ok()) return owner.status();
  std::unique_ptr<JobStore> store(new JobStore(path, *std::move(database), *std::move(owner)));
  if (absl::Status status = store->ReleaseDeadOwners(); !status.ok()) return status;
  return store;
}

JobStore::JobStore(std::string path, std::unique_ptr<Database> database, OwnerLock owner)
    : path_(std::move(path)),
      owner_(std::move(owner)),
      database_(std::move(database)),
      jobs_(*database_),
      events_(*database_),
      artifacts_(*database_),
      batches_(*database_),
      statuses_(*database_),
      deletions_(*database_) {}

absl::Status JobStore::ReleaseDeadOwners() {
  absl::StatusOr<std::vector<std::string>> owners = jobs_.Owners();
  if (!owners.ok()) return owners.status();
  for (const std::string& id : *owners) {
    if (id == owner() || !OwnerLock::IsDead(owners_path(), id)) continue;
    if (absl::Status status = jobs_.Release(id); !status.ok()) return status;
  }
  return absl::OkStatus();
}

}  // namespace flair::orchestrator
