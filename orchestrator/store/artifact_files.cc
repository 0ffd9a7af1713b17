// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/artifact_files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "orchestrator/store/artifact_id.h"
#include "orchestrator/store/sha256.h"

namespace flair::orchestrator {
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
  if (::fsync(file) != 0) return FileError(path, "cannot flush");
  return absl::OkStatus();
}

// Makes a new name in a folder survive a loss of power. Some file systems refuse; then there is nothing more to do.
void FlushFolder(const std::string& folder) {
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return;
  (void)::fsync(file);
  ::close(file);
}

absl::Status WriteAtomically(const std::string& path, const std::string& bytes) {
  static std::atomic<int> counter = 0;
  const std::string temporary = fmt::format("{}.{}.{}.part", path, ::getpid(), counter++);
  const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0) return FileError(temporary, "cannot create");
  absl::Status status = WriteAll(file, bytes, temporary);
  if (::close(file) != 0 && status.ok()) status = FileError(temporary, "cannot close");
  if (status.ok() && ::rename(temporary.c_str(), path.c_str()) != 0) status = FileError(path, "cannot rename to");
  if (!status.ok()) {
    ::unlink(temporary.c_str());
    return status;
  }
  FlushFolder(std::filesystem::path(path).parent_path());
  return absl::OkStatus();
}

}  // namespace

std::string ArtifactFiles::PathOf(const std::string& id) const {
  return fmt::format("{}/{}/{}.pb", folder_, id.substr(0, 2), id);
}

absl::StatusOr<v1::ArtifactRef> ArtifactFiles::Put(v1::Artifact& artifact) const {
  artifact.set_id(ComputeArtifactId(artifact));
  const std::string bytes = CanonicalBytes(artifact);
  v1::ArtifactRef ref;
  ref.set_id(artifact.id());
  ref.set_kind(KindOf(artifact));
  ref.set_size_bytes(static_cast<int64_t>(bytes.size()));
  if (Get(artifact.id()).ok()) return ref;
  const std::string path = PathOf(artifact.id());
  std::error_code error;
  std::filesystem::create_directories(std::filesystem::path(path).parent_path(), error);
  if (error) return absl::UnavailableError(fmt::format("{}: cannot make its folder: {}", path, error.message()));
  if (absl::Status status = WriteAtomically(path, bytes); !status.ok()) return status;
  return ref;
}

absl::StatusOr<v1::Artifact> ArtifactFiles::Get(const std::string& id) const {
  if (!IsArtifactId(id)) {
    return absl::InvalidArgumentError(
        fmt::format("artifact_id: \"{}\" is not an id; expected 64 characters 0-9 and a-f", id.substr(0, 80)));
  }
  const std::string path = PathOf(id);
  std::ifstream file(path, std::ios::binary);
  if (!file) return absl::NotFoundError(fmt::format("artifact {}: not in this store", id));
  const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  v1::Artifact artifact;
  if (!artifact.ParseFromString(bytes)) {
    return absl::DataLossError(fmt::format("{}: damaged: its {} bytes are not an artifact", path, bytes.size()));
  }
  const std::string found = ComputeArtifactId(artifact);
  if (found != id || artifact.id() != id) {
    return absl::DataLossError(fmt::format("{}: damaged: its content has the id {}", path, found));
  }
  return artifact;
}

}  // namespace flair::orchestrator
