// SPDX-License-Identifier: GPL-3.0-or-later
// Files and folders of results, written whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "absl/status/status.h"

namespace flair::cli {

struct OutputFile {
  std::string name;
  std::string content;
};

// Says before the work begins whether `folder` can be written: FAILED_PRECONDITION when it cannot, when it is a file,
// or when it holds files of the given names that are not Flair's. Leaves nothing behind.
absl::Status CheckOutputFolder(const std::filesystem::path& folder, const std::vector<std::string>& names);

// Writes the files into a temporary folder beside `folder`, then puts it in place: by one rename when the folder is new
// or holds only files of these names, else file by file, leaving all others alone. A process that is killed leaves the
// old state and perhaps a folder ".NAME.flair-XXXXXX".
absl::Status WriteOutputFolder(const std::filesystem::path& folder, const std::vector<OutputFile>& files);

// Says before the work begins whether WriteOutputFile will be able to: FAILED_PRECONDITION when not. Leaves nothing
// behind. An empty path is fine: nothing will be written.
absl::Status CheckOutputFile(const std::filesystem::path& path);

// One file, whole or not at all. A device or pipe of that name is written to and stays what it is.
absl::Status WriteOutputFile(const std::filesystem::path& path, const std::string& content);

// FAILED_PRECONDITION with the path and why, of an errno.
absl::Status CannotWrite(const std::filesystem::path& path, int error);

// A file, whole or not at all; the disk may have it later.
absl::Status WriteFile(const std::filesystem::path& path, const std::string& content);

// Returns when the disk has all that was written to the file system of `path`: one call for thousands of files.
absl::Status FlushFileSystem(const std::filesystem::path& path);

// Returns when the disk has the file.
absl::Status FlushFile(const std::filesystem::path& path);

}  // namespace flair::cli
