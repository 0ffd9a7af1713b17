// SPDX-License-Identifier: GPL-3.0-or-later
// Artifacts as files: binary as Flair writes them, or JSON and protobuf text, which people may change.
#pragma once

#include <filesystem>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "flair/v1/artifact.pb.h"

namespace flair::cli {

// An artifact whose file could be read, good or not.
struct ArtifactFile {
  // As it is to be used: its id is the digest of its bytes unless `whole` says that it is not.
  v1::Artifact artifact;
  // Whether it was changed outside of Flair (MarkEdited).
  bool edited = false;
  // The id that the file states; empty when it states none.
  std::string stated_id;
  // DATA_LOSS when a binary file's bytes do not have the id that it states.
  absl::Status whole;
  // INVALID_ARGUMENT with what is wrong with its content, a line each: "graph.json:41: layout_graph.edges[3].weight:
  // ...".
  absl::Status good;
};

// Refuses what is no artifact: other kinds of files, cut off and damaged ones (DATA_LOSS), text with faults and
// artifacts of a newer Flair (INVALID_ARGUMENT); otherwise as ReadFile.
absl::StatusOr<ArtifactFile> ReadArtifactFile(const std::filesystem::path& path);
// The same of the file's bytes.
absl::StatusOr<ArtifactFile> ParseArtifactFile(const std::filesystem::path& path, const std::string& bytes);

// A whole and good one, see ArtifactFile.
absl::StatusOr<v1::Artifact> ReadArtifact(const std::filesystem::path& path);

// DATA_LOSS when the artifact's id is not the digest of its bytes.
absl::Status CheckArtifactId(const v1::Artifact& artifact, const std::filesystem::path& path);

// Makes of an artifact that was changed outside of Flair one of its own: made from the one that it was and from what
// that was made from, by "flair", method "edited by hand", version "of " and who made it before the change; with a new
// id.
void MarkEdited(v1::Artifact& artifact);

// Whether it is one of MarkEdited.
bool IsEdited(const v1::Artifact& artifact);

}  // namespace flair::cli
