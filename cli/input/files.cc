// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "absl/cleanup/cleanup.h"
#include "cli/exit_code.h"
#include "cli/output/output_folder.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {

namespace {

constexpr size_t kLargestFile = 256u << 20;

absl::Status CannotRead(const std::filesystem::path& path) {
  return FileError(fmt::format("{}: cannot be read: {}", path.string(), std::strerror(errno)));
}

absl::Status NotThere(const std::filesystem::path& path) {
  if (errno == ELOOP) return FileError(fmt::format("{}: a link that leads back to itself", path.string()));
  if (errno != ENOENT && errno != ENOTDIR) return CannotRead(path);
  std::error_code error;
  const std::filesystem::path target = std::filesystem::read_symlink(path, error);
  if (error) return absl::NotFoundError(fmt::format("{}: no such file", path.string()));
  return absl::NotFoundError(fmt::format("{}: a link to {}, which does not exist", path.string(), target.string()));
}

// What is no regular file is not read: it may have no end, or wait for one.
absl::Status CheckKind(const std::filesystem::path& path, const struct stat& status) {
  const char* kind = nullptr;
  if (S_ISDIR(status.st_mode)) return FileError(fmt::format("{}: is a folder", path.string()));
  if (S_ISFIFO(status.st_mode)) kind = "a pipe";
  if (S_ISSOCK(status.st_mode)) kind = "a socket";
  if (S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode)) kind = "a device";
  if (kind != nullptr) {
    return FileError(fmt::format("{}: is {}; save its output to a file and give that", path.string(), kind));
  }
  if (status.st_size >= 0 && static_cast<size_t>(status.st_size) <= kLargestFile) return absl::OkStatus();
  return absl::InvalidArgumentError(
      fmt::format("{}: has {} MiB; at most {}", path.string(), status.st_size >> 20, kLargestFile >> 20));
}

}  // namespace

absl::StatusOr<std::string> ReadFile(const std::filesystem::path& path) {
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0) return NotThere(path);
  RETURN_IF_ERROR(CheckKind(path, status));
  // Not blocking: opening a pipe would wait for whoever writes into it.
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) return CannotRead(path);
  const absl::Cleanup close = [file] { ::close(file); };
  if (::fstat(file, &status) != 0) return CannotRead(path);
  RETURN_IF_ERROR(CheckKind(path, status));  // another file may have its name by now
  // One byte more than it says: the last read, which finds the end, then needs no room of its own.
  std::string content(static_cast<size_t>(status.st_size) + 1, '\0');
  for (size_t used = 0;;) {
    const ssize_t count = ::read(file, content.data() + used, content.size() - used);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return CannotRead(path);
    used += static_cast<size_t>(count);
    if (count == 0) {
      content.resize(used);
      return content;
    }
    if (used < content.size()) continue;
    if (used > kLargestFile) {
      return absl::InvalidArgumentError(fmt::format("{}: grows beyond {} MiB", path.string(), kLargestFile >> 20));
    }
    content.resize(std::min(2 * used + 4096, kLargestFile + 1));
  }
}

namespace fs = std::filesystem;

absl::StatusOr<std::vector<fs::path>> FindFoldersWith(const fs::path& root, const std::string& name, size_t most) {
  std::error_code error;
  if (!fs::exists(root, error) && !error) {
    return absl::NotFoundError(fmt::format("{}: no such folder; give a folder of designs", root.string()));
  }
  if (!fs::is_directory(root, error)) {
    return FileError(fmt::format("{}: is not a folder; give a folder of designs", root.string()));
  }
  std::vector<fs::path> found;
  if (fs::is_regular_file(root / name, error)) found.push_back(root);
  error.clear();
  fs::recursive_directory_iterator entry(root, fs::directory_options::skip_permission_denied, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    std::error_code ignored;
    if (entry->is_directory(ignored) && fs::is_regular_file(entry->path() / name, ignored))
      found.push_back(entry->path());
    if (found.size() > most) break;
  }
  if (error) return FileError(fmt::format("{}: cannot be listed: {}", root.string(), error.message()));
  if (found.empty()) return absl::NotFoundError(fmt::format("{}: no folder in it holds a {}", root.string(), name));
  if (found.size() > most) {
    return absl::InvalidArgumentError(
        fmt::format("{}: holds more than {} designs; give a part of them", root.string(), most));
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace flair::cli
