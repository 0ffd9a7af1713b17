// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "flair/v1/artifact.pb.h"

namespace flair::cli {

// The artifact in its binary form, with the id as it states it. DATA_LOSS, "NAME: ...", for bytes that are cut off,
// damaged or none of an artifact; INVALID_ARGUMENT for whole artifacts with parts that only a newer Flair knows.
absl::StatusOr<v1::Artifact> ParseBinaryArtifact(const std::string& name, const std::string& bytes);

// Whether the artifact that was read from these bytes has the id of its bytes.
bool IsWhole(const v1::Artifact& artifact, const std::string& bytes);

}  // namespace flair::cli
