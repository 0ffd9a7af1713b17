// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "absl/status/statusor.h"
#include "flair/v1/room.pb.h"

namespace flair::cli {

// A room: an artifact that holds one (also a layout's or graph's), or a Room message itself, in any of their forms.
// Errors as ReadArtifact.
absl::StatusOr<v1::Room> ReadRoom(const std::filesystem::path& path);

}  // namespace flair::cli
