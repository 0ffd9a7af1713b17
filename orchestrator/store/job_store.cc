// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/job_store.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/file.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <random>
#include <utility>

#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

constexpr int kLookAnywayMs = 1000;
constexpr int kBurstMs = 20;

// Empties the queue of a non-blocking inotify file; true when one of the events came from `watch`.
bool Drain(int file, int watch) {
  alignas(inotify_event) char buffer[4096];
  bool seen = false;
  ssize_t size;
  while ((size = ::read(file, buffer, sizeof buffer)) > 0) {
    for (ssize_t at = 0; at < size;) {
      const auto* event = reinterpret_cast<const inotify_event*>(buffer + at);
      seen |= event->wd == watch;
      at += static_cast<ssize_t>(sizeof(inotify_event) + event->len);
    }
  }
  return seen;
}

}  // namespace

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
    return Unavailable("{}: cannot create and lock: {}", path, std::strerror(code));
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
  if (const std::error_code error = runtime::MakePrivateFolder(path)) {
    return Unavailable("store_path: cannot create the folder {}: {}", path, error.message());
  }
  ASSIGN_OR_RETURN(auto database, Database::Open(path + "/jobs.db"));
  ASSIGN_OR_RETURN(OwnerLock owner, OwnerLock::Acquire(path + "/owners"));
  std::unique_ptr<JobStore> store(new JobStore(path, std::move(database), std::move(owner)));
  RETURN_IF_ERROR(store->ReleaseDeadOwners());
  return store;
}

absl::Status JobStore::ReleaseDeadOwners() {
  ASSIGN_OR_RETURN(const std::vector<std::string> owners, jobs_.Owners());
  for (const std::string& id : owners) {
    if (id == owner() || !OwnerLock::IsDead(owners_path(), id)) continue;
    RETURN_IF_ERROR(jobs_.Release(id).status());
  }
  return absl::OkStatus();
}

StoreMonitor::StoreMonitor(JobStore& store, Callbacks callbacks) : store_(store), callbacks_(std::move(callbacks)) {
  stop_file_ = ::eventfd(0, EFD_CLOEXEC);
  notify_file_ = ::inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
  ::inotify_add_watch(notify_file_, store.path().c_str(), IN_MODIFY);
  owners_watch_ = ::inotify_add_watch(notify_file_, store.owners_path().c_str(), IN_CLOSE_WRITE | IN_DELETE);
  ChangedElsewhere();
  thread_ = std::thread([this] { Watch(); });
}

StoreMonitor::~StoreMonitor() {
  ::eventfd_write(stop_file_, 1);
  thread_.join();
  if (notify_file_ >= 0) ::close(notify_file_);
  ::close(stop_file_);
}

void StoreMonitor::Watch() {
  pollfd files[] = {{stop_file_, POLLIN, 0}, {notify_file_, POLLIN, 0}};
  while (true) {
    const int ready = ::poll(files, 2, kLookAnywayMs);
    if ((files[0].revents & POLLIN) != 0) return;
    // A burst of writes, most of which are our own, is worth one look.
    if (ready > 0 && ::poll(files, 1, kBurstMs) > 0) return;
    const bool owner_gone = Drain(notify_file_, owners_watch_) || ready == 0;
    if (owner_gone) callbacks_.owner_gone();
    if (ChangedElsewhere()) callbacks_.changed();
  }
}

bool StoreMonitor::ChangedElsewhere() {
  const auto lock = store_.database().lock();
  Statement version = store_.database().Prepare("PRAGMA data_version");
  const absl::StatusOr<bool> row = version.Step();
  if (!row.ok() || !*row) return false;
  const int64_t seen = std::exchange(version_, version.Int(0));
  return seen != version_;
}

}  // namespace flair::orchestrator
