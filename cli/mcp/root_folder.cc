// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mcp/root_folder.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>
#include <vector>

#include "absl/strings/ascii.h"
#include "absl/strings/str_split.h"
#include "cli/output/output_folder.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli::mcp {
namespace {

namespace fs = std::filesystem;

constexpr off_t kMostOfOurs = off_t{256} << 20;

class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  Descriptor(Descriptor&& other) noexcept : value_(std::exchange(other.value_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(value_, other.value_);
    return *this;
  }
  ~Descriptor() {
    if (value_ >= 0) ::close(value_);
  }
  int get() const { return value_; }

 private:
  int value_;
};

// The folders and the file of a path.
absl::StatusOr<std::vector<std::string>> PartsOf(const std::string& path) {
  std::vector<std::string> parts;
  for (const auto part : absl::StrSplit(path, '/')) {
    if (part.empty() || part == ".") continue;
    if (part == "..") return InvalidArgument("path: {}: leaves the folder that may be written to", path);
    for (const char c : part) {
      if (absl::ascii_iscntrl(static_cast<unsigned char>(c))) {
        return absl::InvalidArgumentError("path: holds a control character");
      }
    }
    parts.emplace_back(part);
  }
  if (parts.empty() || path.ends_with('/')) return InvalidArgument("path: {}: names no file", path);
  return parts;
}

absl::Status Cannot(const std::string& path, int error) {
  if (error == ELOOP || error == ENOTDIR) {
    return InvalidArgument("path: {}: meets a link or a file where a folder should be", path);
  }
  return FailedPrecondition("path: {}: cannot be written: {}", path, std::strerror(error));
}

// What is there already; empty when it cannot be read or is too large to be ours.
std::string ContentOf(int folder, const std::string& name, off_t size) {
  const Descriptor file(::openat(folder, name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  std::string content;
  if (file.get() < 0 || size > kMostOfOurs) return content;
  content.resize(static_cast<size_t>(size));
  size_t done = 0;
  while (done < content.size()) {
    const ssize_t count = ::read(file.get(), content.data() + done, content.size() - done);
    if (count <= 0) break;
    done += static_cast<size_t>(count);
  }
  content.resize(done);
  return content;
}

}  // namespace

absl::StatusOr<RootFolder> RootFolder::Open(const fs::path& folder) {
  std::error_code error;
  const fs::path path = fs::canonical(folder, error);
  if (error) return FailedPrecondition("--root: {}: {}", folder.string(), error.message());
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return FailedPrecondition("--root: {}: {}", path.string(), std::strerror(errno));
  return RootFolder(path, descriptor);
}

RootFolder::RootFolder(RootFolder&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

RootFolder::~RootFolder() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

absl::StatusOr<std::string> RootFolder::Write(const std::string& given, const std::string& content,
                                              const Replacing& replacing) const {
  std::string relative = given;
  // Agents like to name files by their whole path.
  const std::string prefix = path_.string() == "/" ? "/" : path_.string() + "/";
  if (relative.starts_with(prefix)) relative.erase(0, prefix.size());
  if (relative.starts_with('/')) {
    return InvalidArgument("path: {}: is outside {}, where files may be written", given, path_.string());
  }
  ASSIGN_OR_RETURN(std::vector<std::string> parts, PartsOf(relative));
  const std::string name = std::move(parts.back());
  parts.pop_back();
  Descriptor folder(::fcntl(descriptor_, F_DUPFD_CLOEXEC, 0));
  for (const std::string& part : parts) {
    if (::mkdirat(folder.get(), part.c_str(), 0777) != 0 && errno != EEXIST) return Cannot(given, errno);
    Descriptor next(::openat(folder.get(), part.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    if (next.get() < 0) return Cannot(given, errno);
    folder = std::move(next);
  }
  struct stat there;
  const bool exists = ::fstatat(folder.get(), name.c_str(), &there, AT_SYMLINK_NOFOLLOW) == 0;
  if (exists && !S_ISREG(there.st_mode)) return InvalidArgument("path: {}: is a link, a folder or a device", given);
  if (exists && !replacing.any && !replacing.ours(name, ContentOf(folder.get(), name, there.st_size))) {
    return absl::AlreadyExistsError(
        fmt::format("path: {}: is there already and is not Flair's; take another path, or set overwrite", given));
  }
  static std::atomic<int> counter = 0;
  const std::string fresh = fmt::format(".flair-{}-{}", ::getpid(), counter++);
  {
    const Descriptor file(
        ::openat(folder.get(), fresh.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
    if (file.get() < 0) return Cannot(given, errno);
    const int error = WriteAll(file.get(), content);
    if (error != 0) {
      ::unlinkat(folder.get(), fresh.c_str(), 0);
      return Cannot(given, error);
    }
  }
  // What has come to be there meanwhile is not replaced either.
  const auto put = [&](unsigned flags) {
    return ::renameat2(folder.get(), fresh.c_str(), folder.get(), name.c_str(), flags) == 0 ? 0 : errno;
  };
  int error = put(exists ? 0 : RENAME_NOREPLACE);
  // Some file systems cannot tell.
  if (error == EINVAL) error = put(0);
  if (error != 0) {
    ::unlinkat(folder.get(), fresh.c_str(), 0);
    return Cannot(given, error);
  }
  fs::path path = path_;
  for (const std::string& part : parts) path /= part;
  return (path / name).string();
}

}  // namespace flair::cli::mcp
