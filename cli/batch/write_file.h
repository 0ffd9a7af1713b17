// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "absl/status/status.h"

namespace flair::cli {

// FAILED_PRECONDITION with the path and why, of an errno.
absl::Status CannotWrite(const std::filesystem::path& path, int error);

// A file, whole or not at all; the disk may have it later.
absl::Status WriteFile(const std::filesystem::path& path, const std::string& content);

// Returns when the disk has all that was written to the file system of `path`: one call for thousands of files.
absl::Status FlushFileSystem(const std::filesystem::path& path);

// Returns when the disk has the file.
absl::Status FlushFile(const std::filesystem::path& path);

}  // namespace flair::cli
