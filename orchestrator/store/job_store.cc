// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/job_store.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <random>
#include <utility>

namespace flair::orchestrator {

absl::StatusOr<OwnerLock> OwnerLock::Acquire(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  std::random_device random;
  std::string id = fmt::format("{}-{:08x}{:08x}", ::getpid(), random(), random());
  std::string path = fmt::format("{}/{}.lock", folder, id);
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (file < 0 || ::flock(file, LOCK_EX | LOCK_NB) != 0) {
    const int code = errno;
    if (file >= 0) ::close(file);
    return absl::UnavailableError(fmt::format("{}: cannot create and lock: {}", path, std::strerror(code)));
  }
  return OwnerLock(std::move(id), std::move(path), file);
}

OwnerLock::OwnerLock(OwnerLock&& other) noexcept
    : id_(std::move(other.id_)), path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)) {}

OwnerLock::~OwnerLock() {
  if (file_ < 0) return;
  ::unlink(path_.c_str());
  ::close(file_);
}

bool OwnerLock::IsDead(const std::string& folder, const std::string& id) {
  const std::string path = fmt::format("{}/{}.lock", folder, id);
  const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
  if (file < 0) return errno == ENOENT;
  const bool dead = ::flock(file, LOCK_EX | LOCK_NB) == 0;
  if (dead) ::unlink(path.c_str());
  ::close(file);
  return dead;
}

absl::StatusOr<std::unique_ptr<JobStore>> JobStore::Open(const std::string& path) {
  if (path.empty()) return absl::InvalidArgumentError("store_path: missing; expected a folder for jobs and artifacts");
  std::error_code error;
  // What a store holds is its owner's business.
  const bool is_new = std::filesystem::create_directories(path, error);
  if (is_new) std::filesystem::permissions(path, std::filesystem::perms::owner_all, error);
  if (error) {
    return absl::UnavailableError(fmt::format("store_path: cannot create the folder {}: {}", path, error.message()));
  }
  ASSIGN_OR_RETURN(auto database, Database::Open(path + "/jobs.db"));
  ASSIGN_OR_RETURN(OwnerLock owner, OwnerLock::Acquire(path + "/owners"));
  std::unique_ptr<JobStore> store(new JobStore(path, std::move(database), std::move(owner)));
  RETURN_IF_ERROR(store->ReleaseDeadOwners().status());
  return store;
}

absl::StatusOr<bool> JobStore::ReleaseDeadOwners() {
  bool released = false;
  ASSIGN_OR_RETURN(const std::vector<std::string> owners, jobs_.Owners());
  for (const std::string& id : owners) {
    if (id == owner() || !OwnerLock::IsDead(owners_path(), id)) continue;
    RETURN_IF_ERROR(jobs_.Release(id));
    released = true;
  }
  return released;
}

}  // namespace flair::orchestrator
