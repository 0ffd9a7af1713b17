// SPDX-License-Identifier: GPL-3.0-or-later
// Files and folders of results, written whole or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

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

// Writes all of it to an open file; 0, or the errno that stopped it.
int WriteAll(int file, std::string_view content);

// FAILED_PRECONDITION with the path and why, of an errno.
absl::Status CannotWrite(const std::filesystem::path& path, int error);

// A file, whole or not at all; the disk may have it later.
absl::Status WriteFile(const std::filesystem::path& path, const std::string& content);

// Returns when the disk has all that was written to the file system of `path`: one call for thousands of files.
absl::Status FlushFileSystem(const std::filesystem::path& path);

// Returns when the disk has the file.
absl::Status FlushFile(const std::filesystem::path& path);

// Files and folders that a user names.

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
