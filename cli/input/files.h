// SPDX-License-Identifier: GPL-3.0-or-later
// Files and folders that a user names.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "absl/status/statusor.h"

namespace flair::cli {

// The content of a regular file of at most 256 MiB; links are followed to one. NOT_FOUND when there is none,
// INVALID_ARGUMENT when it is too large (found out before anything is read), FAILED_PRECONDITION when it is a folder,
// a pipe, a device or a socket, or cannot be read.
absl::StatusOr<std::string> ReadFile(const std::filesystem::path& path);

// `root` and the folders below it, at any depth, that hold a file called `name`, sorted; links to folders are not
// followed. NOT_FOUND when there is none, FAILED_PRECONDITION when `root` cannot be listed, INVALID_ARGUMENT when
// there are more than `most`.
absl::StatusOr<std::vector<std::filesystem::path>> FindFoldersWith(const std::filesystem::path& root,
                                                                   const std::string& name, size_t most);

}  // namespace flair::cli
