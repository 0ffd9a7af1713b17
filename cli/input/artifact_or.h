// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/message.h>

#include <filesystem>
#include <functional>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/artifact.pb.h"
#include "room/validation/validate.h"

namespace flair::cli {

// Reads a file that holds a whole and good artifact, or a message of another type by itself: fills the one or the other
// and returns whether it was the artifact. The message by itself is checked with `problems` once it is filled. Errors
// as ReadArtifact, about what the file seems to hold.
absl::StatusOr<bool> ReadArtifactOr(const std::filesystem::path& path, v1::Artifact& artifact,
                                    google::protobuf::Message& alone,
                                    const std::function<std::vector<validation::Problem>()>& problems);

}  // namespace flair::cli
