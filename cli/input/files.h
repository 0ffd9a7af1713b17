// SPDX-License-Identifier: GPL-3.0-or-later
// Files that the user names.
#pragma once

#include <filesystem>
#include <string>

#include "absl/status/statusor.h"
#include "flair/v1/artifact.pb.h"

namespace flair::cli {

// NOT_FOUND when there is no such file, FAILED_PRECONDITION when it cannot be read.
absl::StatusOr<std::string> ReadFile(const std::filesystem::path& path);

// An artifact in its .pb or .json form, told apart by the content, or as protobuf text when the file is named
// .textproto, .txtpb or .pbtxt. DATA_LOSS when it is none of them. Does not check the id.
absl::StatusOr<v1::Artifact> ReadArtifact(const std::filesystem::path& path);

// A room: an artifact that holds one (also a layout's or graph's), or a Room message itself, as .pb or .json.
absl::StatusOr<v1::Room> ReadRoom(const std::filesystem::path& path);

// DATA_LOSS when the artifact's id is not the digest of its bytes.
absl::Status CheckArtifactId(const v1::Artifact& artifact, const std::filesystem::path& path);

}  // namespace flair::cli
