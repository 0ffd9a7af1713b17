// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "absl/status/statusor.h"

namespace flair::cli {

// `root` and the folders below it, at any depth, that hold a file called `name`, sorted; links to folders are not
// followed. NOT_FOUND when there is none, FAILED_PRECONDITION when `root` cannot be listed, INVALID_ARGUMENT when
// there are more than `most`.
absl::StatusOr<std::vector<std::filesystem::path>> FindFoldersWith(const std::filesystem::path& root,
                                                                   const std::string& name, size_t most);

}  // namespace flair::cli
