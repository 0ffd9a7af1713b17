// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/files/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <set>
#include <utility>
#include <vector>

namespace flair::runtime {
namespace {

absl::Status FileError(const std::string& path, const char* what) {
  const int error = errno;
  const std::string message = fmt::format("{}: {}: {}", path, what, std::strerror(error));
  return error == ENOSPC || error == EDQUOT ? absl::ResourceExhaustedError(message) : absl::UnavailableError(message);
}

absl::Status WriteAll(int file, const std::string& bytes, const std::string& path) {
  size_t written = 0;
  while (written < bytes.size()) {
    const ssize_t count = ::write(file, bytes.data() + written, bytes.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return FileError(path, "cannot write");
    written += static_cast<size_t>(count);
  }
  return absl::OkStatus();
}

// Makes a new name in a folder survive a loss of power. Some file systems refuse; then there is nothing more to do.
void FlushFolder(const std::string& folder) {
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return;
  (void)::fsync(file);
  ::close(file);
}

}  // namespace

absl::Status WriteFileAtomically(const std::string& path, const std::string& bytes, Durability durability) {
  static std::atomic<int> counter = 0;
  const std::string temporary = fmt::format("{}.{}.{}.part", path, ::getpid(), counter++);
  const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0) return FileError(temporary, "cannot create");
  absl::Status status = WriteAll(file, bytes, temporary);
  const bool flush = durability == Durability::kPowerLoss;
  if (status.ok() && flush && ::fsync(file) != 0) status = FileError(temporary, "cannot flush");
  if (::close(file) != 0 && status.ok()) status = FileError(temporary, "cannot close");
  if (status.ok() && ::rename(temporary.c_str(), path.c_str()) != 0) status = FileError(path, "cannot rename to");
  if (!status.ok()) {
    ::unlink(temporary.c_str());
    return status;
  }
  if (flush) FlushFolder(std::filesystem::path(path).parent_path());
  return absl::OkStatus();
}

absl::Status FlushFiles(std::span<const std::string> paths) {
  // All are given to the disk before the first is waited for: then one commit of the file system's journal covers the
  // names and places of all, instead of one for each.
  std::vector<std::pair<int, const std::string*>> files;
  std::set<std::string> folders;
  for (const std::string& path : paths) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) continue;
    (void)::sync_file_range(file, 0, 0, SYNC_FILE_RANGE_WRITE);
    files.emplace_back(file, &path);
    folders.insert(std::filesystem::path(path).parent_path());
  }
  absl::Status status;
  for (const auto& [file, path] : files) {
    if (status.ok() && ::fsync(file) != 0) status = FileError(*path, "cannot flush");
    ::close(file);
  }
  if (!status.ok()) return status;
  for (const std::string& folder : folders) FlushFolder(folder);
  return absl::OkStatus();
}

}  // namespace flair::runtime
