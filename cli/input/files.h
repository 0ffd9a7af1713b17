// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "absl/status/statusor.h"

namespace flair::cli {

// The content of a regular file of at most 256 MiB; links are followed to one. NOT_FOUND when there is none,
// INVALID_ARGUMENT when it is too large (found out before anything is read), FAILED_PRECONDITION when it is a folder,
// a pipe, a device or a socket, or cannot be read.
absl::StatusOr<std::string> ReadFile(const std::filesystem::path& path);

}  // namespace flair::cli
