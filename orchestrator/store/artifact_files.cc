// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/artifact_files.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "orchestrator/store/artifact_id.h"
#include "worker_runtime/files/atomic_file.h"
#include "worker_runtime/files/sha256.h"

namespace flair::orchestrator {

std::string ArtifactFiles::PathOf(const std::string& id) const {
  return fmt::format("{}/{}/{}.pb", folder_, id.substr(0, 2), id);
}

absl::StatusOr<v1::ArtifactRef> ArtifactFiles::Put(v1::Artifact& artifact) const {
  artifact.set_id(ComputeArtifactId(artifact));
  const std::string bytes = runtime::CanonicalBytes(artifact);
  v1::ArtifactRef ref;
  ref.set_id(artifact.id());
  ref.set_kind(KindOf(artifact));
  ref.set_size_bytes(static_cast<int64_t>(bytes.size()));
  if (Get(artifact.id()).ok()) return ref;
  const std::string path = PathOf(artifact.id());
  std::error_code error;
  std::filesystem::create_directories(std::filesystem::path(path).parent_path(), error);
  if (error) return absl::UnavailableError(fmt::format("{}: cannot make its folder: {}", path, error.message()));
  if (absl::Status status = runtime::WriteFileAtomically(path, bytes); !status.ok()) return status;
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
