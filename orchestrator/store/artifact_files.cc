// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/artifact_files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <vector>

#include "orchestrator/store/artifact_id.h"
#include "worker_runtime/files/atomic_file.h"

namespace flair::orchestrator {
namespace {

// Nothing when there is no such file.
std::optional<std::string> ReadFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) return std::nullopt;
  std::string bytes(static_cast<size_t>(std::max<std::streamoff>(0, file.tellg())), '\0');
  file.seekg(0);
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<size_t>(file.gcount()));
  return bytes;
}

}  // namespace

absl::StatusOr<std::unique_ptr<ArtifactStore>> ArtifactFiles::Open(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || ::access(folder.c_str(), W_OK) != 0) {
    return absl::UnavailableError(fmt::format("the folder for artifacts, {}, cannot be {}: {}", folder,
                                              error ? "made" : "written to",
                                              error ? error.message() : std::strerror(errno)));
  }
  return std::make_unique<ArtifactFiles>(folder);
}

std::string ArtifactFiles::PathOf(const std::string& id) const {
  return fmt::format("{}/{}/{}.pb", folder_, id.substr(0, 2), id);
}

absl::Status ArtifactFiles::PutAll(std::span<const SealedArtifact> artifacts) {
  for (const SealedArtifact& artifact : artifacts) {
    if (absl::Status status = PutOne(artifact); !status.ok()) return status;
  }
  return absl::OkStatus();
}

absl::Status ArtifactFiles::PutOne(const SealedArtifact& artifact) const {
  const std::string path = PathOf(artifact.ref.id());
  if (ReadFile(path) == artifact.bytes) return absl::OkStatus();
  const std::string folder = std::filesystem::path(path).parent_path();
  std::error_code error;
  if (!std::filesystem::exists(folder, error)) std::filesystem::create_directories(folder, error);
  if (error) return absl::UnavailableError(fmt::format("{}: cannot make its folder: {}", path, error.message()));
  return runtime::WriteFileAtomically(path, artifact.bytes, runtime::Durability::kProcessCrash);
}

absl::Status ArtifactFiles::Flush(std::span<const v1::ArtifactRef> artifacts) {
  std::vector<std::string> paths;
  for (const v1::ArtifactRef& artifact : artifacts) {
    if (IsArtifactId(artifact.id())) paths.push_back(PathOf(artifact.id()));
  }
  return runtime::FlushFiles(paths);
}

absl::StatusOr<v1::Artifact> ArtifactFiles::Get(const std::string& id) {
  if (!IsArtifactId(id)) {
    return absl::InvalidArgumentError(
        fmt::format("artifact_id: \"{}\" is not an id; expected 64 characters 0-9 and a-f", id.substr(0, 80)));
  }
  const std::string path = PathOf(id);
  const std::optional<std::string> bytes = ReadFile(path);
  if (!bytes.has_value()) return absl::NotFoundError(fmt::format("artifact {}: not in this store", id));
  v1::Artifact artifact;
  if (!AreBytesOf(*bytes, id) || !artifact.ParseFromString(*bytes)) {
    return absl::DataLossError(
        fmt::format("{}: damaged: its {} bytes are not those of the artifact with that id", path, bytes->size()));
  }
  return artifact;
}

}  // namespace flair::orchestrator
